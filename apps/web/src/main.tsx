/** Entry of the page: starts the worker, builds the services, mounts React. */
import { createRoot } from "react-dom/client";
import { I18nextProvider } from "react-i18next";
import { App } from "./app/App.tsx";
import { createServices, ServicesProvider } from "./app/services.ts";
import { createI18n } from "./text/i18n.ts";
import { firstMaze, firstProgram } from "./app/first-visit.ts";

const worker = new Worker(new URL("./worker/simulator.worker.ts", import.meta.url), {
  type: "module",
});
const root = document.getElementById("root");
if (root === null) throw new Error("index.html has no #root");
createRoot(root).render(
  <I18nextProvider i18n={createI18n()}>
    <ServicesProvider value={createServices(worker, firstMaze, firstProgram)}>
      <App />
    </ServicesProvider>
  </I18nextProvider>,
);
