/** Adds a ghost from the link of a run. */
import { Plus } from "lucide-react";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../ui/Button.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { TextField } from "../../ui/TextField.tsx";
import type { RaceService } from "./race-service.ts";
import styles from "./race.module.css";

const NOTE_ID = "race-link-note";

export function AddGhost({ race }: { race: RaceService }) {
  const { t } = useTranslation(["race", "words"], { useSuspense: false });
  const [link, setLink] = useState("");
  const [problem, setProblem] = useState<string | null>(null);
  const [isBusy, setBusy] = useState(false);

  async function add(): Promise<void> {
    setBusy(true);
    try {
      setProblem(await problemOf());
    } catch {
      setProblem(t("race:refused.failed"));
    } finally {
      setBusy(false);
    }
  }

  /** Adds the ghost. @returns why it is not in the race; null when it is */
  async function problemOf(): Promise<string | null> {
    const { decodeLink } = await import("@corridor/link");
    const read = decodeLink(link.slice(link.indexOf("#") + 1).trim());
    if (!read.ok) return t(`words:share.linkProblems.${read.code}`);
    const { run } = read.value;
    if (run === undefined) return t("race:refused.not-a-run");
    const refusal = await race.add(run);
    if (refusal !== null) return race.refusalText(refusal, run);
    setLink("");
    return null;
  }

  return (
    <form
      className={styles["add"]}
      onSubmit={(event) => {
        event.preventDefault();
        void add();
      }}
    >
      <div className={styles["field"]}>
        <TextField
          label={t("race:link")}
          value={link}
          onChange={(text) => {
            setLink(text);
            setProblem(null);
          }}
          dir="ltr"
          spellCheck={false}
          aria-invalid={problem !== null}
          aria-describedby={NOTE_ID}
        />
        {problem === null ? (
          <p id={NOTE_ID} className={styles["note"]}>
            {t("race:linkNote")}
          </p>
        ) : (
          <FieldError id={NOTE_ID}>{problem}</FieldError>
        )}
      </div>
      <Button
        type="submit"
        disabled={isBusy || link.trim() === ""}
        icon={<Plus aria-hidden="true" />}
      >
        {t("race:add")}
      </Button>
    </form>
  );
}
