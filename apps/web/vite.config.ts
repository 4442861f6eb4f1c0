import react from "@vitejs/plugin-react";
import { defineConfig } from "vite";
import { VitePWA } from "vite-plugin-pwa";
import { scopedName, shellClasses } from "./build/class-names.ts";
import { englishWords } from "./build/english-words.ts";
import { firstScript } from "./build/first-script.ts";
import { layerOrder } from "./build/layer-order.ts";
import { leanClasses } from "./build/lean-classes.ts";
import { licenses } from "./build/licenses.ts";
import { precompress } from "./build/precompress.ts";
import { publish } from "./build/publish.ts";

/** Paths of the page that open offline. The relay serves all others. */
const PAGE = /^\/(?:(?:teach|join|class\/[\w-]{22})\/?)?(\?.*)?$/;

const thirdParty = licenses();

/** The first screen names a hundred files that load later: a letter less of each is 0.1 KiB. */
const chunkFileNames = "assets/[name]-[hash:7].js";

export default defineConfig({
  root: import.meta.dirname,
  plugins: [
    // Compiled components are larger: with all of them, the first screen grows by a tenth. Only
    // large components that render while the robot drives opt in with "use memo".
    react({ compiler: { compilationMode: "annotation" } }),
    VitePWA({
      // The page registers the service worker when it is idle, and asks before an update.
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
            // Alphabets that only names of mazes and programs need; each loads on first use.
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
    thirdParty.page,
    precompress(),
    publish(),
  ],
  worker: {
    format: "es",
    plugins: () => [thirdParty.worker()],
    rolldownOptions: { output: { chunkFileNames } },
  },
  css: { modules: { generateScopedName: scopedName } },
  build: {
    // The Content-Security-Policy forbids scripts in data: URLs.
    assetsInlineLimit: 0,
    target: "es2022",
    modulePreload: {
      polyfill: false,
      // The page preloads its dynamic imports itself, so lists of their files are not needed.
      resolveDependencies: (_file, dependencies, { hostType }) =>
        hostType === "html" ? dependencies : [],
    },
    rolldownOptions: {
      // No getter has side effects, so unused reads of properties can be removed.
      treeshake: { propertyReadSideEffects: false },
      output: {
        chunkFileNames,
        codeSplitting: {
          // One file that rarely changes stays in the cache of browsers across versions.
          groups: [
            {
              name: "react",
              test: /node_modules\/(?:react|react-dom|scheduler|i18next|react-i18next|zustand|zundo|use-sync-external-store)|ui\/(?:Button|Icon|button\.module|class-names|field\.module)|icons\/x\.|maze-limits|maze-cells|languages\.ts|program\/src\/(?:vocabulary|condition-parts|same-program)|rolldown\/runtime|vite\/preload-helper|src\/text\/numbers/,
            },
            // Otherwise each module that another page shares with the first screen becomes a file.
            { name: "page", tags: ["$initial"] },
          ],
        },
      },
    },
    // e2e/first-screen.spec.ts limits the size of a first visit.
    chunkSizeWarningLimit: 700,
  },
});
