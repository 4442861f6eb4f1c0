/** A page for each kind of problem, at the path in `type`, and their index. */
import { problemKinds } from "../../platform/errors/problem-kinds.ts";
import type { ProblemText } from "../../platform/errors/problem-text.ts";
import type { Page } from "./frame.ts";
import { htmlOf } from "./markdown.ts";

const kinds: [string, ProblemText][] = Object.entries(problemKinds);

export const problemPages: readonly Page[] = [
  {
    path: "/problems",
    title: "Problems",
    html: () =>
      htmlOf(`# Problems

Each error response is a [problem document](/docs/limits#errors). \`type\` is the path of one of these pages.
[Limits and errors](/docs/limits#retry) lists the responses to retry.

| Status | \`type\` | Title |
| --- | --- | --- |
${kinds.map(([kind, { status, title }]) => `| ${status} | [/problems/${kind}](/problems/${kind}) | ${title} |`).join("\n")}
`),
  },
  ...kinds.map(([kind, text]) => ({
    path: `/problems/${kind}`,
    title: text.title,
    html: () => htmlOf(wordsOf(kind, text)),
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
