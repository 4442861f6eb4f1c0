/** Writes XML. All text of others passes through `escapeXml`. */

const escapes: Readonly<Record<string, string>> = {
  "&": "&amp;",
  "<": "&lt;",
  ">": "&gt;",
  '"': "&quot;",
  // Parsers would normalise it.
  "\r": "&#13;",
};

/** Characters that XML 1.0 cannot contain, not even escaped, and halves of surrogate pairs. */
// oxlint-disable-next-line no-control-regex -- these are the characters to find
const FORBIDDEN = /[\u0000-\u0008\u000B\u000C\u000E-\u001F\uFFFE\uFFFF]|\p{Surrogate}/gu;

/** The text for the contents of an element or a quoted attribute. */
export function escapeXml(text: string): string {
  return text
    .replaceAll(FORBIDDEN, "\uFFFD")
    .replaceAll(/[&<>"\r]/g, (character) => escapes[character] ?? character);
}

/** An element with its contents. @param name with its attributes, if it has any */
export function element(name: string, contents: string): string {
  const [tag = ""] = name.split(" ", 1);
  return contents === "" ? `<${name}/>` : `<${name}>${contents}</${tag}>`;
}
