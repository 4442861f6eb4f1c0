/** The texts of a pairing: which script asks, and the outcome. */
import type { TFunction } from "i18next";
import type { PairingQuestion, PairingView } from "./robot-pairing.ts";

/** "Right wall (Python script) wants to drive this robot." */
export function questionText(t: TFunction, question: PairingQuestion): string {
  return t("remote.pair.asks", { script: scriptText(t, question) });
}

/** The outcome in a sentence; empty while there is none. */
export function newsText(t: TFunction, view: PairingView): string {
  if (view.trouble === "tooManyKeys") return t("remote.pair.tooManyKeys");
  if (view.trouble === "failed") return t("remote.actionFailed");
  if (view.kind === "over") return t("remote.pair.over");
  if (view.kind !== "accepted" && view.kind !== "refused") return "";
  return t(`remote.pair.${view.kind}`, { script: scriptText(t, view.question) });
}

/** "Right wall (Python script)", or "A script". */
function scriptText(t: TFunction, { name, client }: PairingQuestion): string {
  const language =
    client === "" || client === "Script"
      ? t("remote.someScript")
      : t("remote.scriptIn", { language: client });
  return name === null ? language : t("remote.pair.named", { name, language });
}
