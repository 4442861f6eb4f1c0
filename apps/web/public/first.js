// What cannot wait for the page's own script: theme, contrast and the way the script runs, before the
// first paint, and the simulator worker, which gets ready while that script is still on its way. A file of its own, since
// the page's Content-Security-Policy forbids inline scripts; src/app/theme.ts, language.ts
// and simulator-start.ts take over.
(() => {
  const { simulator } = document.currentScript.dataset;
  // The address is there in a build; while Corridor is developed the page starts the worker.
  if (simulator) {
    const worker = new Worker(simulator, { type: "module" });
    window.corridorSimulator = { worker, failure: null };
    // A file that does not come has no message.
    worker.onerror = (event) => (window.corridorSimulator.failure = String(event.message ?? ""));
  }
  // Without the page's script, or without words, the English of index.html is all that can be said.
  window.corridorFailed = (...words) => {
    const [alert] = document.getElementById("failed").content.children;
    if (words.length > 0) alert.lang = alert.dir = "";
    words.forEach((text, at) => (alert.children[at].textContent = text));
    alert.lastElementChild.onclick = () => location.reload();
    document.getElementById("root").replaceChildren(alert);
  };
  addEventListener("error", ({ target }) => target.tagName === "SCRIPT" && corridorFailed(), true);
  let theme = null;
  let contrast = null;
  let language = null;
  try {
    theme = localStorage.getItem("corridor.theme");
    contrast = localStorage.getItem("corridor.contrast");
    language = localStorage.getItem("corridor.language");
  } catch {
    // Storage is forbidden: the system decides.
  }
  if (theme !== "light" && theme !== "dark") {
    theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  }
  if (contrast !== "more") {
    contrast = matchMedia("(prefers-contrast: more)").matches ? "more" : "normal";
  }
  Object.assign(document.documentElement.dataset, { theme, contrast });
  language = new URLSearchParams(location.search).get("lang") ?? language ?? navigator.language;
  if (/^ar\b/.test(language)) document.documentElement.dir = "rtl";
})();
