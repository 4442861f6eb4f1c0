/** The project's own Markdown as HTML. It reads what the repository holds, and nothing from outside. */
import { Marked, type Tokens } from "marked";

/** What a link in a file of docs/ leads to where that file is served. */
export type Address = (href: string) => string;

const asItIs: Address = (href) => href;

/**
 * Renders Markdown.
 * @param text from the repository
 * @param address maps the target of each link to the served page
 */
export function htmlOf(text: string, address: Address = asItIs): string {
  const marked = new Marked({ async: false });
  marked.use({
    renderer: {
      heading({ tokens, text: words, depth }) {
        return `<h${depth} id="${slugOf(words)}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
      // What is wider than a phone is scrolled, by keyboard too.
      code(token) {
        return `<pre tabindex="0"><code>${escaped(token.text)}</code></pre>\n`;
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
        // A neighbour that is not served has no link.
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
