/** One field for the letters on the board. */
import type { JoinedClass } from "@corridor/protocol";
import { useEffect, useId, useRef, useState, type SubmitEvent } from "react";
import { useTranslation } from "react-i18next";
import { shownCode } from "../../model/classes/shown-code.ts";
import { Button } from "../../ui/Button.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { TextField } from "../../ui/TextField.tsx";
import { joinClass, type JoinProblem } from "./join-class.ts";
import styles from "./join.module.css";

/** Longest text that the relay reads. */
const MAX_TYPED = 32;

interface JoinFormProps {
  /** of the address; may be empty */
  code: string;
  onJoin: (joined: JoinedClass) => void;
}

export function JoinForm({ code, onJoin }: JoinFormProps) {
  const { t } = useTranslation("join", { useSuspense: false });
  const [typed, setTyped] = useState(() => shownCode(code.slice(0, MAX_TYPED)));
  const [problem, setProblem] = useState<JoinProblem | null>(null);
  const [isJoining, setJoining] = useState(false);
  const field = useRef<HTMLInputElement>(null);
  // The field is all that this page is for.
  useEffect(() => field.current?.focus(), []);
  const noteId = useId();
  const errorId = useId();
  const join = async (event: SubmitEvent): Promise<void> => {
    event.preventDefault();
    // A second student must not join because of a double click.
    if (isJoining) return;
    setJoining(true);
    setProblem(null);
    const result = await joinClass(typed, (url, request) => fetch(url, request));
    if (result.ok) return onJoin(result.value);
    setJoining(false);
    setProblem(result.problem);
    field.current?.focus();
  };
  return (
    <form className={styles["card"]} noValidate onSubmit={(event) => void join(event)}>
      <h1 className={styles["title"]}>{t("title")}</h1>
      <div className={styles["code"]}>
        <TextField
          ref={field}
          label={t("letters")}
          value={typed}
          onChange={setTyped}
          maxLength={MAX_TYPED}
          dir="ltr"
          autoCapitalize="characters"
          spellCheck={false}
          aria-invalid={problem !== null}
          aria-describedby={problem === null ? noteId : `${errorId} ${noteId}`}
        />
      </div>
      {problem !== null && (
        <FieldError id={errorId}>{t(`problem.${problem.kind}`, problem)}</FieldError>
      )}
      <p id={noteId} className={styles["note"]}>
        {t("lettersNote")}
      </p>
      <div className={styles["actions"]}>
        {problem?.kind === "old" && (
          <Button size="large" onClick={() => location.reload()}>
            {t("reload")}
          </Button>
        )}
        <Button kind="primary" size="large" type="submit" aria-disabled={isJoining}>
          {t("join")}
        </Button>
      </div>
      <p className={styles["note"]}>{t("camera")}</p>
    </form>
  );
}
