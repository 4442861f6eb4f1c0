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
  },
});
