/* The API console. Swagger UI is a classic script with a global; both scripts are deferred. */

// Swagger UI renders descriptions as sanitised HTML. Trusted Types permit only plain tags.
const PLAIN = /^(?:[^<]|<\/?(?:p|code|pre|strong|em|ul|ol|li|br)>)*$/;
globalThis.trustedTypes?.createPolicy("default", {
  createHTML: (html) => (PLAIN.test(html) ? html : null),
});

// A class enables the dark colours of Swagger UI.
const dark = matchMedia("(prefers-color-scheme: dark)");
const paint = () => document.documentElement.classList.toggle("dark-mode", dark.matches);
dark.addEventListener("change", paint);
paint();

globalThis.SwaggerUIBundle({
  url: "/openapi.json",
  domNode: document.querySelector("#console"),
  presets: [globalThis.SwaggerUIBundle.presets.apis],
  // No requests to other servers.
  validatorUrl: null,
  docExpansion: "list",
  defaultModelsExpandDepth: 0,
  tryItOutEnabled: true,
  persistAuthorization: false,
  onComplete: () => {
    // The page already has a main landmark.
    for (const part of document.querySelectorAll("#console main, #console [role=main]")) {
      part.setAttribute("role", "group");
    }
  },
});
