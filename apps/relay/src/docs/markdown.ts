/**
 * The project's own Markdown as HTML: headings, paragraphs, lists, tables, code, and links. It reads
 * what stands in docs/ and nothing from outside; all text is escaped all the same.
 */

/** @param text such as docs/protocol.md @param top heading level of `#` */
export function htmlOf(text: string, top = 2): string {
  return blocksOf(text.split("\n"))
    .map((block) => htmlOfBlock(block, top))
    .join("\n");
}

/** Lines that belong together: what blank lines divide, code too, and each heading alone. */
function blocksOf(lines: readonly string[]): string[][] {
  const blocks: string[][] = [[]];
  for (const line of lines) {
    if (line.trim() === "" || line.startsWith("#")) blocks.push([]);
    if (line.trim() !== "") blocks.at(-1)?.push(line);
    if (line.startsWith("#")) blocks.push([]);
  }
  return blocks.filter((block) => block.length > 0);
}

function htmlOfBlock(block: readonly string[], top: number): string {
  const [first = ""] = block;
  const heading = /^(#+) (.*)$/.exec(first);
  if (heading !== null) {
    const [, marks = "", words = ""] = heading;
    const level = Math.min(6, marks.length + top - 1);
    return `<h${level} id="${slugOf(words)}">${inline(words)}</h${level}>`;
  }
  if (first.startsWith("```")) return code(block.slice(1, -1));
  if (first.startsWith("|")) return table(block);
  if (first.startsWith("- ")) return list(block);
  return `<p>${inline(block.join(" "))}</p>`;
}

function code(lines: readonly string[]): string {
  return `<pre tabindex="0"><code>${escaped(lines.join("\n"))}</code></pre>`;
}

function table([head = "", _rule, ...rows]: readonly string[]): string {
  const line = (row: string, tag: string): string =>
    `<tr>${cellsOf(row)
      .map((cell) => `<${tag}>${inline(cell)}</${tag}>`)
      .join("")}</tr>`;
  const body = rows.map((row) => line(row, "td")).join("");
  // What is wider than a phone is scrolled, by keyboard too.
  return `<div class="table" tabindex="0"><table><thead>${line(head, "th")}</thead><tbody>${body}</tbody></table></div>`;
}

function cellsOf(row: string): string[] {
  return row
    .split("|")
    .slice(1, -1)
    .map((cell) => cell.trim());
}

/** Lines that begin further in belong to the item before; those with a dash are its own list. */
function list(lines: readonly string[]): string {
  const items: string[][] = [];
  for (const line of lines) {
    if (line.startsWith("- ")) items.push([line.slice(2)]);
    else items.at(-1)?.push(line.replace(/^ {2}/, ""));
  }
  const html = items.map((item) => {
    const below = item.findIndex((line) => line.startsWith("- "));
    const words = item.slice(0, below < 0 ? item.length : below).map((line) => line.trim());
    return `<li>${inline(words.join(" "))}${below < 0 ? "" : list(item.slice(below))}</li>`;
  });
  return `<ul>${html.join("")}</ul>`;
}

function inline(text: string): string {
  return text
    .split(/(`[^`]+`)/)
    .map((part) =>
      part.startsWith("`")
        ? `<code>${escaped(part.slice(1, -1))}</code>`
        : escaped(part)
            .replaceAll(/\*\*([^*]+)\*\*/g, "<strong>$1</strong>")
            .replaceAll(/\[([^\]]+)\]\(([^)\s]+)\)/g, (_all, words: string, to: string) =>
              // A neighbour in docs/ is not served.
              to.startsWith("#") ? `<a href="${to}">${words}</a>` : words,
            ),
    )
    .join("");
}

function slugOf(words: string): string {
  return words
    .toLowerCase()
    .replaceAll(/[^\w ]/g, "")
    .replaceAll(" ", "-");
}

function escaped(text: string): string {
  return text
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;")
    .replaceAll('"', "&quot;");
}
