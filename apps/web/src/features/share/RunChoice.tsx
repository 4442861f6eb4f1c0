/** The choice to share the run itself, and to save it as a file. */
import type { WrittenRun } from "@corridor/recording";
import { Download } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { saveDocument } from "../../ui/save-file.ts";
import styles from "./share.module.css";

interface RunChoiceProps {
  isChosen: boolean;
  onChange: (isChosen: boolean) => void;
  /** null until the simulator has written it */
  saved: WrittenRun | null;
}

export function RunChoice({ isChosen, onChange, saved }: RunChoiceProps) {
  const { t } = useTranslation();
  const { run } = useServices();
  const isRun = useStore(run, ({ nowTick }) => nowTick > 0);
  return (
    <>
      <Checkbox
        label={t("timeline.share.run")}
        note={t(isRun ? "timeline.share.note" : "timeline.share.noRun")}
        checked={isChosen}
        disabled={!isRun}
        onChange={onChange}
      />
      {saved?.ok === true && (
        <Button
          size="small"
          className={styles["saveRun"]}
          icon={<Icon of={Download} />}
          onClick={() => saveDocument(saved.run, "run")}
        >
          {t("timeline.share.save")}
        </Button>
      )}
    </>
  );
}
