/** A page for each kind of problem, at the URL that `type` names, and the list of them. */
import { problemKinds, type ProblemText } from "../problem-kinds.ts";
import type { Page } from "./frame.ts";
import { htmlOf } from "./markdown.ts";

const kinds: [string, ProblemText][] = Object.entries(problemKinds);

export const problemPages: readonly Page[] = [
  {
    path: "/problems",
    title: "Problems",
    html: htmlOf(`# Problems

Every error answer is a problem document (RFC 9457): JSON with \`type\`, \`title\`, \`status\`, \`detail\` and \`errors\`.
\`type\` is the path of a page here. \`detail\` says what happened in this case and what to do.

| Status | \`type\` | What happened |
| --- | --- | --- |
${kinds.map(([kind, { status, title }]) => `| ${status} | [/problems/${kind}](/problems/${kind}) | ${title} |`).join("\n")}
`),
  },
  ...kinds.map(([kind, text]) => ({
    path: `/problems/${kind}`,
    title: text.title,
    html: htmlOf(wordsOf(kind, text)),
  })),
];

function wordsOf(kind: string, { status, title, what, why, fix }: ProblemText): string {
  return `# ${title}

HTTP status ${status}, \`"type": "/problems/${kind}"\`

## What happened

${what}

## Why

${why}

## What to do

${fix.map((step) => `- ${step}`).join("\n")}

[All problems](/problems)
`;
}
