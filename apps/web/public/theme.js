// Sets theme and contrast before the first paint. A file of its own, since the page's
// Content-Security-Policy forbids inline scripts; src/app/theme.ts takes over once the page runs.
(() => {
  let theme = null;
  let contrast = null;
  try {
    theme = localStorage.getItem("corridor.theme");
    contrast = localStorage.getItem("corridor.contrast");
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
})();
