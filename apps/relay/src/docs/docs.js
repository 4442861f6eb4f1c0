/* The console of /docs. Swagger UI is a plain script with a global of its own; both wait until the text stands. */

// Swagger UI shows descriptions as markup, which it has cleaned: here only plain tags get any further (Trusted Types).
const PLAIN = /^(?:[^<]|<\/?(?:p|code|pre|strong|em|ul|ol|li|br)>)*$/;
globalThis.trustedTypes?.createPolicy("default", {
  createHTML: (html) => (PLAIN.test(html) ? html : null),
});

// Its dark colours wait for a class.
const dark = matchMedia("(prefers-color-scheme: dark)");
const paint = () => document.documentElement.classList.toggle("dark-mode", dark.matches);
dark.addEventListener("change", paint);
paint();

globalThis.SwaggerUIBundle({
  url: "/openapi.json",
  domNode: document.querySelector("#console"),
  presets: [globalThis.SwaggerUIBundle.presets.apis],
  // Nothing is asked of anybody else.
  validatorUrl: null,
  docExpansion: "list",
  defaultModelsExpandDepth: 0,
  tryItOutEnabled: true,
  persistAuthorization: false,
  onComplete: () => {
    // The page has a main part of its own.
    for (const part of document.querySelectorAll("#console main, #console [role=main]")) {
      part.setAttribute("role", "group");
    }
  },
});
