/**
 * Generates packages/client/REFERENCE.md from the doc comments of the TypeScript library (`npm run
 * reference`). This workspace has the TypeScript version with a compiler API.
 */
import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import ts from "typescript";

const CLIENT = new URL("../../packages/client/", import.meta.url);
const ENTRY = fileURLToPath(new URL("src/index.ts", CLIENT));

export const REFERENCE = fileURLToPath(new URL("REFERENCE.md", CLIENT));

/** The exported names by group, in reading order. */
export const groups: Readonly<Record<string, readonly string[]>> = {
  "The robot": [
    "RobotClient",
    "RobotClientOptions",
    "CommandOptions",
    "MotionOptions",
    "DriveOptions",
    "UntilCondition",
  ],
  "What a robot reports": [
    "Snapshot",
    "SensorReadings",
    "Pose",
    "CommandRecord",
    "RobotEvent",
    "RobotMaze",
    "MazeCell",
  ],
  Errors: ["ClientError", "ClientErrorCode"],
};

const INTRODUCTION = `# Reference of the TypeScript library

\`import { RobotClient } from "@corridor/client"\`. Every public class and type with its methods, properties, parameters and
errors, made from the doc comments, which an editor shows as well. [The TypeScript library](README.md) shows how to use them.
`;

interface LibraryReference {
  text: string;
  /** every exported name */
  names: string[];
  /** names, members and parameters without a doc comment */
  undocumented: string[];
}

export function libraryReference(): LibraryReference {
  const program = ts.createProgram([ENTRY], {
    target: ts.ScriptTarget.ES2024,
    module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext,
    lib: ["lib.es2024.d.ts"],
    types: [],
    strict: true,
    exactOptionalPropertyTypes: true,
    allowImportingTsExtensions: true,
    noEmit: true,
  });
  const checker = program.getTypeChecker();
  const source = program.getSourceFile(ENTRY);
  const entry = source && checker.getSymbolAtLocation(source);
  if (entry === undefined) throw new Error(`${ENTRY} is no module`);
  const symbols = new Map(
    checker.getExportsOfModule(entry).map((symbol) => {
      const isAlias = (symbol.flags & ts.SymbolFlags.Alias) !== 0;
      return [symbol.name, isAlias ? checker.getAliasedSymbol(symbol) : symbol];
    }),
  );
  const undocumented: string[] = [];
  const link = (name: string) => `[\`${name}\`](#${name.toLowerCase()})`;
  const linked = (type: string) => (symbols.has(type) ? link(type) : `\`${escapeCell(type)}\``);

  function docOf(symbol: ts.Symbol, name: string): string {
    const doc = ts.displayPartsToString(symbol.getDocumentationComment(checker)).trim();
    if (doc === "") undocumented.push(name);
    return doc;
  }

  function tagsOf(symbol: ts.Symbol, tag: string): string[] {
    return symbol
      .getJsDocTags(checker)
      .filter(({ name }) => name === tag)
      .map(({ text }) => oneLine(ts.displayPartsToString(text)));
  }

  function typeOf(symbol: ts.Symbol): string {
    const declaration = symbol.valueDeclaration ?? symbol.declarations?.[0];
    const declared =
      declaration !== undefined &&
      (ts.isPropertySignature(declaration) || ts.isPropertyDeclaration(declaration)) &&
      declaration.type?.getText();
    if (declared !== undefined && declared !== false) return oneLine(declared);
    const type = checker.getTypeOfSymbol(symbol);
    // The full union of commands is too long for a table cell.
    const isCommand = symbol.name === "command" && type.getProperty("seq") === undefined;
    if (isCommand && type.getProperty("action") !== undefined) return "object";
    const text = checker.typeToString(type, undefined, ts.TypeFormatFlags.NoTruncation);
    return withTypeNames(isLiteralUnion(type) ? sorted(text.split(" | ")) : text);
  }

  /** Replaces inline object types by the exported names of the same shape. */
  function withTypeNames(text: string): string {
    for (const [name, symbol] of symbols) {
      const shape = checker.typeToString(
        checker.getDeclaredTypeOfSymbol(symbol),
        undefined,
        ts.TypeFormatFlags.NoTruncation | ts.TypeFormatFlags.InTypeAlias,
      );
      if (shape.startsWith("{")) text = text.replaceAll(shape, name);
    }
    return text;
  }

  function table(owner: string, properties: readonly ts.Symbol[]): string {
    if (properties.length === 0) return "";
    const rows = properties.map((property) => {
      const isOptional = (property.flags & ts.SymbolFlags.Optional) !== 0;
      const doc = docOf(property, `${owner}.${property.name}`);
      const name = `\`${property.name}${isOptional ? "?" : ""}\``;
      return `| ${name} | ${linked(typeOf(property))} | ${oneLine(doc)} |`;
    });
    return `| Property | Type | Meaning |\n| --- | --- | --- |\n${rows.join("\n")}\n`;
  }

  function method(owner: string, symbol: ts.Symbol): string {
    const declaration = symbol.valueDeclaration;
    if (declaration === undefined || !ts.isMethodDeclaration(declaration)) return "";
    const name = `${owner}.${symbol.name}`;
    const isStatic = declaration.modifiers?.some(
      ({ kind }) => kind === ts.SyntaxKind.StaticKeyword,
    );
    const doc = docOf(symbol, name);
    const parameters = declaration.parameters.map((parameter) => oneLine(parameter.getText()));
    const result = oneLine(declaration.type?.getText() ?? "");
    const call = `${isStatic ? owner : "robot"}.${symbol.name}`;
    const short = `${call}(${parameters.join(", ")}): ${result}`;
    const long = `${call}(\n${parameters.map((each) => `  ${each},\n`).join("")}): ${result}`;
    const paramDocs = new Map(
      tagsOf(symbol, "param").map((text) => {
        const space = text.indexOf(" ");
        return [text.slice(0, space), text.slice(space + 1)];
      }),
    );
    const lines = declaration.parameters.map((parameter) => {
      const own = parameter.name.getText();
      const text = paramDocs.get(own);
      if (text === undefined) undocumented.push(`${name}: ${own}`);
      return `- \`${own}\`: ${text}`;
    });
    const returns = tagsOf(symbol, "returns");
    if (returns.length === 0 && result !== "void") undocumented.push(`${name}: what it returns`);
    lines.push(...returns.map((text) => `- Returns ${text}`));
    lines.push(...tagsOf(symbol, "throws").map((text) => `- Throws ${withLink(text)}`));
    const signature = `\`\`\`ts\n${short.length > 80 ? long : short}\n\`\`\`\n`;
    const list = lines.length === 0 ? "" : `\n${lines.join("\n")}\n`;
    return `#### \`${name}\`\n\n${doc}\n\n${signature}${list}`;
  }

  /** Renders a @throws text such as `ClientError bad-address, ...` with the class as a link. */
  function withLink(text: string): string {
    const [name = "", ...codes] = text.split(" ");
    return `${symbols.has(name) ? link(name) : name}: ${codes.join(" ")}`;
  }

  /** A table of a union's members, each with the comment above it. */
  function members(name: string, node: ts.UnionTypeNode): string {
    const text = node.getSourceFile().text;
    let end = node.getFullStart();
    const rows = node.types.map((member) => {
      const [, doc = ""] = /\/\*\*([^]*?)\*\//.exec(text.slice(end, member.getStart())) ?? [];
      end = member.getEnd();
      if (doc === "") undocumented.push(`${name}: ${member.getText()}`);
      return `| \`${escapeCell(oneLine(member.getText()))}\` | ${oneLine(doc)} |`;
    });
    return `| Value | Meaning |\n| --- | --- |\n${rows.join("\n")}\n`;
  }

  function section(name: string): string {
    const symbol = symbols.get(name);
    if (symbol === undefined) throw new Error(`${name} is not exported`);
    const head = `### \`${name}\`\n\n${docOf(symbol, name)}\n`;
    const alias = symbol.declarations?.find(ts.isTypeAliasDeclaration);
    if (alias !== undefined && ts.isUnionTypeNode(alias.type)) {
      return `${head}\n${members(name, alias.type)}`;
    }
    const type = checker.getDeclaredTypeOfSymbol(symbol);
    const own = checker.getPropertiesOfType(type).filter((each) => isOwn(each));
    const statics = [...(symbol.exports?.values() ?? [])].filter(
      (each) => (each.flags & ts.SymbolFlags.Method) !== 0,
    );
    const methods = [...statics, ...own].filter(
      (each) => (each.flags & ts.SymbolFlags.Method) !== 0 && each.valueDeclaration !== undefined,
    );
    const properties = own.filter((each) => (each.flags & ts.SymbolFlags.Method) === 0);
    const texts = methods.map((each) => method(name, each));
    return [head, table(name, properties), ...texts].filter((part) => part !== "").join("\n");
  }

  /** Excludes private (`#name`) members and those of the built-in `Error`. */
  function isOwn(symbol: ts.Symbol): boolean {
    const file = symbol.declarations?.[0]?.getSourceFile().fileName ?? "";
    const name = symbol.valueDeclaration && ts.getNameOfDeclaration(symbol.valueDeclaration);
    const isPrivate = name !== undefined && ts.isPrivateIdentifier(name);
    return !isPrivate && !file.includes("/typescript/lib/");
  }

  const lists = Object.entries(groups).map(
    ([title, names]) => `- ${title}: ${names.map(link).join(", ")}`,
  );
  const sections = Object.entries(groups).map(
    ([title, names]) => `## ${title}\n\n${names.map(section).join("\n")}`,
  );
  const text = `${INTRODUCTION}\n${lists.join("\n")}\n\n${sections.join("\n")}`;
  return { text, names: [...symbols.keys()], undocumented };
}

/** A union of literals and null. Its printed order depends on the compiler's earlier work. */
function isLiteralUnion(type: ts.Type): boolean {
  return (
    type.isUnion() &&
    type.types.every((each) => each.isLiteral() || (each.flags & ts.TypeFlags.Null) !== 0)
  );
}

function sorted(members: readonly string[]): string {
  const isNull = (member: string) => (member === "null" ? 1 : 0);
  return members.toSorted((a, b) => isNull(a) - isNull(b) || (a < b ? -1 : 1)).join(" | ");
}

function oneLine(text: string): string {
  return text.replaceAll(/\s+/g, " ").trim();
}

/** Escapes `|`, which would end a table cell. */
function escapeCell(text: string): string {
  return text.replaceAll("|", "\\|");
}

if (import.meta.main) writeFileSync(REFERENCE, libraryReference().text);
