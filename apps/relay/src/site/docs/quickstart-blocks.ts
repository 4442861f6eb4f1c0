/**
 * Quickstarts in Markdown: `<!-- quickstart: ID -->` stands for the text that the page offers to copy,
 * with placeholders for the parts of the robot's address. It has the id `connect-ID`.
 */
import { quickstartIds, quickstarts, type Quickstart } from "@corridor/quickstarts";
import type { GatewayName } from "@corridor/protocol";

const PLACEHOLDERS = { origin: "http://HOST", id: "ID", key: "KEY", urlKey: "url_KEY" };

const BLOCK = /<!-- quickstart: (\w+) -->/g;
/** A `### NAME` section between the comments of tabs. */
const SECTION = /^### .*\n(?:(?!### |<!-- end of tabs -->).*\n)*/gm;

/**
 * Replaces each comment with its text, and removes the sections of gateways that are switched off.
 * @throws Error for an unknown id
 */
export function withQuickstarts(text: string, gateways: readonly GatewayName[]): string {
  const isOffered = ({ gateway }: Quickstart): boolean =>
    gateway === null || gateways.includes(gateway);
  return text
    .replaceAll(SECTION, (section) => {
      const named = [...section.matchAll(BLOCK)].map(([, id = ""]) => quickstartOf(id));
      return named.every(isOffered) ? section : "";
    })
    .replaceAll(
      BLOCK,
      (_, id: string) =>
        `\`\`\`#connect-${id}\n${quickstartOf(id).text(PLACEHOLDERS).trimEnd()}\n\`\`\``,
    );
}

function quickstartOf(id: string): Quickstart {
  const known = quickstartIds.find((each) => each === id);
  if (known === undefined) throw new Error(`there is no quickstart ${id}`);
  return quickstarts[known];
}
