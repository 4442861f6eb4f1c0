// Sets the theme before the first paint. A file of its own, since the page's Content-Security-Policy
// forbids inline scripts; src/app/theme.ts takes over once the page runs.
(() => {
  let theme = null;
  try {
    theme = localStorage.getItem("corridor.theme");
  } catch {
    // Storage is forbidden: the system decides.
  }
  if (theme !== "light" && theme !== "dark") {
    theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  }
  document.documentElement.dataset.theme = theme;
})();
