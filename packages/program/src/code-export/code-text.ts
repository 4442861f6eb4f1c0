/** Texts that the files of all languages share: conditions, names, and the chain of if and else. */
import type { Condition } from "../program-document.ts";
import type { ScriptLine, UntilComparison } from "./script-lines.ts";

/** Longest line of code before a list of conditions is broken, in columns. */
const MAX_COLUMNS = 96;

/** Such as `right > 60` or `left > right + 1`: valid code in every language. */
function comparisonText(condition: UntilComparison): string {
  const { sensor, is, than } = condition;
  if (than !== "right") return `${sensor} ${is} ${than}`;
  const { plus } = condition;
  return `${sensor} ${is} right ${plus < 0 ? "-" : "+"} ${Math.abs(plus)}`;
}

/** The name in one line of a comment. It can contain no character that ends the comment. */
export function commentName(name: string): string {
  // Java also reads escapes such as \u000a in comments.
  const text = name.replaceAll(/[\p{C}\p{Zl}\p{Zp}\\]+/gu, " ").trim();
  return text === "" ? "A program without a name" : text;
}

/** "line 2", as the badge in the page, or "otherwise". */
function labelOf({ line }: ScriptLine): string {
  return line === "default" ? "otherwise" : `line ${line + 1}`;
}

/** What a file contains besides the calls of the service. */
export interface CodeContent {
  name: string;
  lines: readonly ScriptLine[];
  /** the robot's address as a string literal, which is the same in every language */
  address: string;
  /** starts the file */
  command: string;
}

export interface ChainStyle {
  /** one level of indentation */
  indent: string;
  /** levels around the chain */
  depth: number;
  /** the function of a decision, such as `await drive` */
  call: string;
  /** whether blocks have braces and calls end with a semicolon; else the style of Python */
  hasBraces: boolean;
}

/** The lines of the program as a chain of if and else. */
export function chainOf(lines: readonly ScriptLine[], style: ChainStyle): string {
  const outer = style.indent.repeat(style.depth);
  // A program that has only "otherwise" needs no else.
  if (lines.length === 1) return lines.map((line) => callOf(line, style, outer)).join("");
  const blocks = lines.map((line, at) => {
    const head = headOf(line.when, at === 0, style.hasBraces);
    return `${outer}${head}\n${callOf(line, style, outer + style.indent)}`;
  });
  if (style.hasBraces) blocks.push(`${outer}}`);
  return blocks.join("\n");
}

function headOf(when: Condition | null, isFirst: boolean, hasBraces: boolean): string {
  const keyword = isFirst ? "if" : hasBraces ? "} else if" : "elif";
  if (hasBraces) return when === null ? "} else {" : `${keyword} (${comparisonText(when)}) {`;
  return when === null ? "else:" : `${keyword} ${comparisonText(when)}:`;
}

function callOf(line: ScriptLine, style: ChainStyle, indent: string): string {
  const end = style.hasBraces ? ");" : ")";
  const plus = style.hasBraces ? "+ " : "";
  const start = `${indent}${style.call}("${labelOf(line)}", "${line.action}"`;
  const until = line.until?.map((each) => comparisonText(each)) ?? [];
  if (until.length === 0) return `${start}${end}`;
  const short = `${start}, "${until.join(" or ")}"${end}`;
  if (short.length <= MAX_COLUMNS) return short;
  const deeper = indent + style.indent;
  const parts = wrap(until, MAX_COLUMNS - deeper.length - plus.length - 8);
  const text = parts.map((part, at) => `${deeper}${at > 0 ? plus : ""}"${part}"`).join("\n");
  return `${start},\n${text}${end}`;
}

/** Texts of about a width that together are the conditions, joined by "or". */
function wrap(conditions: readonly string[], width: number): string[] {
  const parts: string[] = [""];
  for (const [at, condition] of conditions.entries()) {
    const text = at < conditions.length - 1 ? `${condition} or ` : condition;
    const last = parts.at(-1) ?? "";
    if (last !== "" && last.length + text.length > width) parts.push(text);
    else parts[parts.length - 1] = last + text;
  }
  return parts;
}
