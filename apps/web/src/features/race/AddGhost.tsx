/** Adds a ghost from the link of a run. */
import { Plus } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import { TextField } from "../../ui/TextField.tsx";
import type { RaceService } from "./race-service.ts";
import styles from "./race.module.css";

const NOTE_ID = "race-link-note";

export function AddGhost({ race }: { race: RaceService }) {
  const { t } = useTranslation("race", { useSuspense: false });
  const [link, setLink] = useState("");
  const [problem, setProblem] = useState<string | null>(null);
  const [isBusy, setBusy] = useState(false);

  async function add(): Promise<void> {
    setBusy(true);
    try {
      setProblem(await problemOf());
    } catch {
      setProblem(t("refused.failed"));
    } finally {
      setBusy(false);
    }
  }

  /**
   * Adds the ghost.
   * @returns why it is not in the race; null if it is
   */
  async function problemOf(): Promise<string | null> {
    const { readRunLink } = await import("./run-link.ts");
    const read = readRunLink(link);
    if (!read.ok) return t(`refused.${read.refusal}`);
    const refusal = await race.add(read.run);
    if (refusal !== null) return race.refusalText(refusal, read.run);
    // The next link may have been pasted meanwhile.
    setLink((now) => (now === link ? "" : now));
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
          label={t("link")}
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
            {t("linkNote")}
          </p>
        ) : (
          <FieldError id={NOTE_ID}>{problem}</FieldError>
        )}
      </div>
      <Button type="submit" disabled={isBusy || link.trim() === ""} icon={<Icon of={Plus} />}>
        {t("add")}
      </Button>
    </form>
  );
}
