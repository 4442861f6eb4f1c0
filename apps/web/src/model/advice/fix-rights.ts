/** Whether an open challenge permits a fix. Otherwise the page does not offer its button. */
import type { Rights } from "@corridor/challenge";
import type { Fix } from "@corridor/coach";
import { kindOf, type Rule } from "@corridor/program";

type FixRights = Pick<Rights, "actions" | "conditions" | "edits" | "maxLines">;

/**
 * @param lines of the program
 * @param rights null while no challenge is open, which permits everything
 */
export function allowsFix(fix: Fix, lines: number, rights: FixRights | null): boolean {
  if (rights === null) return true;
  const { edits, actions } = rights;
  switch (fix.kind) {
    case "action":
      return edits.has("action") && actions.includes(fix.action);
    case "number":
      return edits.has("number");
    case "condition":
      return edits.has("condition") && edits.has("number") && allowsCondition(fix.when, rights);
    case "move":
      return edits.has("order");
    case "delete":
      return edits.has("lines");
    case "insert":
      return (
        edits.has("lines") &&
        lines < rights.maxLines &&
        actions.includes(fix.rule.do) &&
        allowsCondition(fix.rule.when, rights)
      );
  }
}

function allowsCondition(when: Rule["when"], { conditions }: FixRights): boolean {
  return when === null || conditions.includes(kindOf(when));
}
