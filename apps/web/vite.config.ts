import react from "@vitejs/plugin-react";
import { defineConfig } from "vite";
import { VitePWA } from "vite-plugin-pwa";
import { scopedName, shellClasses } from "./build/class-names.ts";
import { englishWords } from "./build/english-words.ts";
import { firstScript } from "./build/first-script.ts";
import { layerOrder } from "./build/layer-order.ts";
import { leanClasses } from "./build/lean-classes.ts";
import { precompress } from "./build/precompress.ts";
import { publish } from "./build/publish.ts";

/** Addresses at which the page shows itself; all others belong to the relay. */
const PAGE = /^\/(\?.*)?$/;

export default defineConfig({
  root: import.meta.dirname,
  plugins: [
    // The compiler's memory costs a tenth of the first screen. It is for components that are drawn
    // again while the robot drives and have much in them: those begin with "use memo".
    react({ compiler: { compilationMode: "annotation" } }),
    VitePWA({
      // The page registers it itself, once it has time, and asks before a new version takes over.
      injectRegister: false,
      registerType: "prompt",
      manifest: {
        id: "/",
        name: "Corridor",
        short_name: "Corridor",
        description:
          "A free robot simulator: build a maze, drive by hand, by dropdown rules or from your own script.",
        start_url: "/",
        scope: "/",
        display: "standalone",
        // --paper and --surface of tokens.css
        background_color: "#eef1f4",
        theme_color: "#ffffff",
        categories: ["education"],
        icons: [
          { src: "/mark.svg", sizes: "any", type: "image/svg+xml" },
          { src: "/icon-192.png", sizes: "192x192", type: "image/png" },
          { src: "/icon-512.png", sizes: "512x512", type: "image/png" },
          {
            src: "/icon-maskable-512.png",
            sizes: "512x512",
            type: "image/png",
            purpose: "maskable",
          },
        ],
      },
      workbox: {
        inlineWorkboxRuntime: true,
        cleanupOutdatedCaches: true,
        // The first visit is offline-ready too, without a reload.
        clientsClaim: true,
        skipWaiting: false,
        globPatterns: [
          "**/*.{js,css,html}",
          "assets/words-*.json",
          "assets/inter-latin-*.woff2",
          "mark.svg",
        ],
        globIgnores: ["assets/inter-latin-ext-*.woff2", "sw.js", "404.html"],
        navigateFallback: "/index.html",
        navigateFallbackAllowlist: [PAGE],
        runtimeCaching: [
          {
            // Alphabets that only names of mazes and programs bring; each comes when it is needed.
            urlPattern: /\/assets\/inter-[^/]*\.woff2$/,
            handler: "CacheFirst",
            options: { cacheName: "corridor-fonts", expiration: { maxEntries: 12 } },
          },
        ],
      },
    }),
    leanClasses(),
    layerOrder(),
    shellClasses(),
    englishWords(),
    firstScript(),
    precompress(),
    publish(),
  ],
  worker: { format: "es" },
  css: { modules: { generateScopedName: scopedName } },
  build: {
    // The Content-Security-Policy forbids data: scripts; small assets stay files too.
    assetsInlineLimit: 0,
    target: "es2022",
    modulePreload: {
      polyfill: false,
      // The page fetches its parts before they are wanted; a list of their parts would only cost.
      resolveDependencies: (_file, dependencies, { hostType }) =>
        hostType === "html" ? dependencies : [],
    },
    rolldownOptions: {
      // No getter does more than answer, so what only reads a property and uses nothing of it goes.
      treeshake: { propertyReadSideEffects: false },
      output: {
        codeSplitting: {
          // One file that outlives most versions of the page, instead of many small ones.
          groups: [
            {
              name: "react",
              test: /node_modules\/(?:react|react-dom|scheduler|i18next|react-i18next|zustand|zundo|use-sync-external-store)|ui\/(?:Button|Icon|button\.module|class-names|field\.module)|icons\/x\.|maze-limits|maze-cells|languages\.ts|program\/src\/(?:vocabulary|condition-parts|same-program)|rolldown\/runtime|vite\/preload-helper|src\/text\/numbers/,
            },
          ],
        },
      },
    },
    // React alone is more; e2e/first-screen.spec.ts holds the sum of what a first visit loads.
    chunkSizeWarningLimit: 700,
  },
});
