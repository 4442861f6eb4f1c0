/** Tabs in Markdown, as radio buttons and CSS. `tabs.js` stores the selection. */
import { escaped, htmlOf, slugOf, type Address } from "./markdown.ts";

const PART = /<!-- tabs: (.*) -->\n([^]*?)<!-- end of tabs -->\n/g;

/** Like `htmlOf`, but renders the `### NAME` sections between the two comments as tabs. */
export function htmlWithTabs(text: string, address?: Address): string {
  let html = "";
  let done = 0;
  for (const part of text.matchAll(PART)) {
    const [whole, legend = "", inside = ""] = part;
    html += htmlOf(text.slice(done, part.index), address) + tabs(legend, inside, address);
    done = part.index + whole.length;
  }
  return html + htmlOf(text.slice(done), address);
}

function tabs(legend: string, text: string, address?: Address): string {
  const group = slugOf(legend);
  const sections = text
    .split(/^### /m)
    .slice(1)
    .map((section) => {
      const end = section.indexOf("\n");
      return { name: section.slice(0, end), text: section.slice(end) };
    });
  const choices = sections.map(
    ({ name }, index) =>
      `<label><input type="radio" name="${group}" value="${escaped(name)}"${index === 0 ? " checked" : ""} />${escaped(name)}</label>`,
  );
  const panels = sections.map(
    ({ name, text: inside }) =>
      `<div class="panel" role="group" aria-label="${escaped(name)}">${htmlOf(inside, address)}</div>`,
  );
  return `<div class="tabs"><fieldset><legend>${escaped(legend)}</legend>${choices.join("")}</fieldset>${panels.join("\n")}</div>\n`;
}
