/** Sizes of the printed pages: a stylesheet of its own, because CSS has no variables for them. */
import { sheetOf, type PaperName } from "./paper.ts";

/** Sheets of both directions can be in one print: each names its page. */
export type PageName = "upright" | "lying";

export function pageName(isLandscape: boolean): PageName {
  return isLandscape ? "lying" : "upright";
}

/**
 * @param first direction of the first sheet, for browsers without named pages
 * @returns the function that removes the sizes
 */
export function setPageSizes(paper: PaperName, first: PageName): () => void {
  const rule = (name: string, isLandscape: boolean) => {
    const { width, height } = sheetOf(paper, isLandscape);
    return `@page ${name} { size: ${width}mm ${height}mm; margin: 0; }`;
  };
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(
    [rule("", first === "lying"), rule("upright", false), rule("lying", true)].join("\n"),
  );
  document.adoptedStyleSheets.push(sheet);
  return () => {
    document.adoptedStyleSheets = document.adoptedStyleSheets.filter((each) => each !== sheet);
  };
}
