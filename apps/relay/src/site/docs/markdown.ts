/** Renders Markdown of the repository as HTML. The input is trusted. */
import { Marked, type Tokens } from "marked";

/** Maps a link in a Markdown file to its URL on the served page; "" removes the link. */
export type Address = (href: string) => string;

const unchanged: Address = (href) => href;

/**
 * Renders Markdown.
 * @param text from the repository
 * @param address maps the target of each link to the served page
 */
export function htmlOf(text: string, address: Address = unchanged): string {
  const marked = new Marked({ async: false });
  marked.use({
    renderer: {
      heading({ tokens, text: words, depth }) {
        return `<h${depth} id="${slugOf(words)}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
      // Focusable, so that the keyboard can scroll wide content. `#NAME` is the id of the block.
      code({ text: code, lang = "" }) {
        const id = lang.startsWith("#") ? ` id="${escaped(lang.slice(1))}"` : "";
        return `<pre${id} tabindex="0"><code>${escaped(code)}</code></pre>\n`;
      },
      table(token) {
        return `<div class="table" tabindex="0">${tableOf(token, (cell) =>
          this.parser.parseInline(cell.tokens),
        )}</div>\n`;
      },
      html: ({ text: markup }) => escaped(markup),
      link({ href, tokens }) {
        const words = this.parser.parseInline(tokens);
        const to = address(href);
        return to === "" ? words : `<a href="${escaped(to)}">${words}</a>`;
      },
    },
  });
  return marked.parse(text) as string;
}

function tableOf({ header, rows }: Tokens.Table, htmlOfCell: (cell: Tokens.TableCell) => string) {
  const line = (cells: readonly Tokens.TableCell[], tag: string): string =>
    `<tr>${cells.map((cell) => `<${tag}>${htmlOfCell(cell)}</${tag}>`).join("")}</tr>`;
  const body = rows.map((row) => line(row, "td")).join("");
  return `<table><thead>${line(header, "th")}</thead><tbody>${body}</tbody></table>`;
}

/** The id of a heading. */
export function slugOf(words: string): string {
  return words
    .toLowerCase()
    .replaceAll(/[^\w -]/g, "")
    .replaceAll(" ", "-");
}

export function escaped(text: string): string {
  return text
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;")
    .replaceAll('"', "&quot;");
}
