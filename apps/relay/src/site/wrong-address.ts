/**
 * HTML page for unknown addresses, with a link home, and to the documentation for addresses in it.
 * It needs no scripts. API paths and clients that do not accept HTML receive a problem document.
 */
import type { ErrorRequestHandler, RequestHandler } from "express";
import { wrongAddressTexts, type WrongAddressTexts } from "./wrong-address-texts.ts";

const API = /^\/api(?:\/|$)/;
const DOCS = /^\/(?:docs|problems)(?:\/|$)/;

/** Treats invalid percent-encoding outside of the API, such as /r/%E0, as an unknown address. */
export const unreadableAddress: ErrorRequestHandler = (
  error: unknown,
  request,
  _response,
  next,
) => {
  next(error instanceof URIError && !API.test(request.path) ? undefined : error);
};

/** @param onNotFound called when the page is sent, for the metrics */
export function wrongAddress(onNotFound: () => void): RequestHandler {
  const languages = Object.keys(wrongAddressTexts);
  return (request, response, next) => {
    const isReadMethod = request.method === "GET" || request.method === "HEAD";
    if (!isReadMethod || API.test(request.path)) return next();
    response.vary("Accept");
    // Clients that accept any type, such as curl, receive the first.
    if (request.accepts(["application/problem+json", "html"]) !== "html") return next();
    // The page adds the chosen language to its links. It overrides the browser's languages.
    const chosen = languages.find((tag) => tag === request.query["lang"]);
    // "zh" matches every requested form of Chinese.
    const accepted = request.acceptsLanguages(["en", "zh", ...languages]);
    const lang = chosen ?? (accepted === "zh" ? "zh-Hans" : accepted === false ? "en" : accepted);
    onNotFound();
    response.vary("Accept-Language").set("Cache-Control", "no-store");
    response.status(404).type("html");
    const homePath = chosen === undefined ? "/" : `/?lang=${chosen}`;
    const texts = wrongAddressTexts[lang] ?? wrongAddressTexts.en;
    response.send(page(lang, homePath, texts, DOCS.test(request.path)));
    return undefined;
  };
}

function page(
  lang: string,
  homePath: string,
  { title, text, home, docs }: WrongAddressTexts,
  isInDocs: boolean,
): string {
  const dir = lang === "ar" ? "rtl" : "ltr";
  return `<!doctype html>
<html lang="${lang}" dir="${dir}">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>${title} - Corridor</title>
    <link rel="icon" href="data:," />
    <link rel="stylesheet" href="/check/check.css" />
  </head>
  <body>
    <header><a href="${homePath}">Corridor</a></header>
    <main>
      <h1>${title}</h1>
      <p>${text}</p>${isInDocs ? `\n      <p><a class="home" href="/docs">${docs}</a></p>` : ""}
      <p><a class="home" href="${homePath}">${home}</a></p>
    </main>
  </body>
</html>
`;
}
