/**
 * The question of a script that has typed the robot's pairing code, wherever the owner is on the
 * page. It is placed below the messages, on a phone in its own row above Run, or in the open modal
 * dialog. It disappears when the Remote panel's question is in view, when it is answered, and when
 * it expires.
 */
import { useEffect, useId, useSyncExternalStore } from "react";
import { createPortal } from "react-dom";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { joinSentences } from "../../text/joined.ts";
import { Button } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { newsText, questionText } from "./pairing-words.ts";
import { pairingOf } from "./robot-pairing.ts";
import styles from "./pairing-call.module.css";

export function PairingCall({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const { screen, run } = useServices();
  const pairing = pairingOf(session);
  const { view, field, isInSight } = useStore(pairing.store);
  const dialog = useSyncExternalStore(onDialogs, openDialog);
  const textId = useId();
  useEffect(() => void pairing.resume(), [pairing]);

  const isInReach = field !== null && (dialog === null || dialog.contains(field));
  const isShown = view.kind === "asked" && !(isInReach && isInSight);
  const press = async (work: Promise<void>): Promise<void> => {
    await work;
    const { view: after } = pairing.store.getState();
    if (after.kind === "asked") return;
    const isLeftToDo = after.kind === "accepted" && run.getState().nowDriver !== "remote";
    const next = isLeftToDo ? [t("remote.cancel.notRemote")] : [];
    showMessage(screen, { tone: "info", text: joinSentences(t, [newsText(t, after), ...next]) });
  };
  const call = (
    <div
      className={classNames(
        isShown ? styles["call"] : "visually-hidden",
        isShown && dialog !== null && styles["inDialog"],
      )}
    >
      {/* Always rendered: screen readers skip a live region that is inserted with its text. The
          panel announces the question too. */}
      <output id={textId} className={styles["text"]} aria-live={isInReach ? "off" : "polite"}>
        {isShown && (
          <>
            {questionText(t, view.question)}
            {view.trouble !== null && (
              <span className={styles["trouble"]}>{newsText(t, view)}</span>
            )}
          </>
        )}
      </output>
      {isShown && (
        <div className={styles["answers"]}>
          <Button
            kind="primary"
            size="large"
            aria-describedby={textId}
            onClick={() => void press(pairing.accept())}
          >
            {t("remote.pair.yes")}
          </Button>
          <Button
            size="large"
            aria-describedby={textId}
            onClick={() => void press(pairing.decline())}
          >
            {t("remote.pair.no")}
          </Button>
        </div>
      )}
    </div>
  );
  return dialog === null ? call : createPortal(call, dialog);
}

/** The topmost modal dialog, if any. */
function openDialog(): Element | null {
  return [...document.querySelectorAll("dialog:modal")].at(-1) ?? null;
}

function onDialogs(look: () => void): () => void {
  const watch = new MutationObserver(look);
  watch.observe(document.body, { subtree: true, attributes: true, attributeFilter: ["open"] });
  return () => watch.disconnect();
}
