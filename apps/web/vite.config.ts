import react from "@vitejs/plugin-react";
import { defineConfig } from "vite";

export default defineConfig({
  root: import.meta.dirname,
  plugins: [react({ compiler: true })],
  worker: { format: "es" },
  build: {
    // The Content-Security-Policy forbids data: scripts; small assets stay files too.
    assetsInlineLimit: 0,
    target: "es2022",
    // React and the schemas make one file of about 190 kB gzip; the size is watched by hand.
    chunkSizeWarningLimit: 700,
  },
});
