/**
 * The page for people at an address that does not exist: what is wrong, and a link home, or to the documentation as well. It needs no script.
 * API paths, and clients that do not ask for HTML, get a problem document instead.
 */
import type { ErrorRequestHandler, RequestHandler } from "express";
import { wrongAddressWords, type WrongAddressWords } from "./wrong-address-words.ts";

const API = /^\/api(?:\/|$)/;
const DOCS = /^\/(?:docs|problems)(?:\/|$)/;

/** Escapes that are no UTF-8, such as /r/%E0: an address of the page that cannot be read is a wrong one. */
export const unreadableAddress: ErrorRequestHandler = (
  error: unknown,
  request,
  _response,
  next,
) => {
  next(error instanceof URIError && !API.test(request.path) ? undefined : error);
};

/** @param refused called when the page was sent, for the metrics */
export function wrongAddress(refused: () => void): RequestHandler {
  const languages = Object.keys(wrongAddressWords);
  return (request, response, next) => {
    const isRead = request.method === "GET" || request.method === "HEAD";
    if (!isRead || API.test(request.path)) return next();
    response.vary("Accept");
    // Clients that take anything, such as curl, get the first.
    if (request.accepts(["application/problem+json", "html"]) !== "html") return next();
    // The page writes the chosen language into its addresses: it counts before the browser's.
    const chosen = languages.find((tag) => tag === request.query["lang"]);
    // "zh" stands for any Chinese that is asked for.
    const accepted = request.acceptsLanguages(["en", "zh", ...languages]);
    const lang = chosen ?? (accepted === "zh" ? "zh-Hans" : accepted === false ? "en" : accepted);
    refused();
    response.vary("Accept-Language").set("Cache-Control", "no-store");
    response.status(404).type("html");
    const way = chosen === undefined ? "/" : `/?lang=${chosen}`;
    const words = wrongAddressWords[lang] ?? wrongAddressWords.en;
    response.send(page(lang, way, words, DOCS.test(request.path)));
    return undefined;
  };
}

function page(
  lang: string,
  way: string,
  { title, text, home, docs }: WrongAddressWords,
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
    <header><a href="${way}">Corridor</a></header>
    <main>
      <h1>${title}</h1>
      <p>${text}</p>${isInDocs ? `\n      <p><a class="home" href="/docs">${docs}</a></p>` : ""}
      <p><a class="home" href="${way}">${home}</a></p>
    </main>
  </body>
</html>
`;
}
