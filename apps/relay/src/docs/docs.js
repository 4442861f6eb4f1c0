/* The console of /docs. Swagger UI is a plain script with a global of its own; it comes last, so that the text is read first. */
const script = document.createElement("script");
script.src = "/docs/swagger-ui-bundle.js";
script.addEventListener("load", () => {
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
});
document.head.append(script);
