/**
 * Messages that the user can dismiss. Information disappears after 6 s; errors and messages with
 * `stays` remain.
 */
import { CircleAlert, X } from "lucide";
import { useEffect, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { dismiss, type Message } from "../../model/screen/screen-store.ts";
import { useAnnouncement } from "../../model/use-announcement.ts";
import { joinSentences } from "../../text/joined.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import styles from "./messages.module.css";

/**
 * Time until information disappears, in ms. It starts again after the message had the focus or the
 * pointer.
 */
const STAYS_MS = 6000;

/** @param children prompts that need an answer, below the messages */
export function Messages({ children }: { children?: ReactNode }) {
  const { t } = useTranslation();
  const { screen, run } = useServices();
  const messages = useStore(screen, (state) => state.messages);
  const isPast = useStore(run, ({ view }) => view !== "now");
  // Errors interrupt a screen reader. Their region is always present, because a region that appears
  // with its text is not read out. Information waits in the speech queue of the page.
  return (
    <section
      className={styles["messages"]}
      aria-label={t("shell.messages")}
      data-past={isPast || undefined}
    >
      <div className={styles["lists"]}>
        <Lists messages={messages.filter((message) => !staysOf(message))} />
      </div>
      <Lists messages={messages.filter(staysOf)} />
      {children}
    </section>
  );
}

function Lists({ messages }: { messages: readonly Message[] }) {
  return (["bad", "info"] as const).map((tone) => (
    <div key={tone} role={tone === "bad" ? "alert" : undefined} className={styles["list"]}>
      {messages
        .filter((message) => message.tone === tone)
        .map((message) => (
          <MessageCard key={message.id} message={message} />
        ))}
    </div>
  ));
}

/** Whether the message remains until the user dismisses it. */
function staysOf({ tone, stays = tone === "bad" }: Message): boolean {
  return stays;
}

function MessageCard({ message }: { message: Message }) {
  const { t } = useTranslation();
  const { screen, speech } = useServices();
  const [isHeld, setIsHeld] = useState(false);
  const { id, tone, text, part, action } = message;
  const stays = staysOf(message);
  const spoken = action === undefined ? text : joinSentences(t, [text, action.label]);
  useAnnouncement(tone === "bad" ? null : spoken, `message ${id}`);
  useEffect(() => () => speech.announceState(`message ${id}`, null), [speech, id]);

  useEffect(() => {
    if (stays || isHeld) return;
    const timer = setTimeout(() => dismiss(screen, id), STAYS_MS);
    return () => clearTimeout(timer);
  }, [screen, id, stays, isHeld]);

  return (
    <span
      className={classNames(styles["card"], styles[tone])}
      onPointerEnter={() => setIsHeld(true)}
      onPointerLeave={() => setIsHeld(false)}
      onFocus={() => setIsHeld(true)}
      onBlur={() => setIsHeld(false)}
    >
      {tone === "bad" && <Icon of={CircleAlert} size={18} />}
      <span className={styles["text"]}>{text}</span>
      {part !== undefined && <progress className={styles["part"]} aria-label={text} value={part} />}
      {action !== undefined && (
        <Button
          size="small"
          kind="quiet"
          className={styles["action"]}
          onClick={() => {
            dismiss(screen, id);
            action.run();
          }}
        >
          {action.label}
        </Button>
      )}
      <IconButton
        label={t("shell.dismiss")}
        className={styles["close"]}
        onClick={() => dismiss(screen, id)}
      >
        <Icon of={X} />
      </IconButton>
    </span>
  );
}
