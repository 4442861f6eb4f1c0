/** What the robot does when no line is true; always last. */
import { setDefault } from "@corridor/program";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useShallow } from "zustand/react/shallow";
import { useServices } from "../../app/services.ts";
import { classNames } from "../../ui/class-names.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { ActionMenu } from "./ActionMenu.tsx";
import { adviceOn } from "./advice-store.ts";
import { AdviceNote } from "./AdviceNote.tsx";
import { LineNote } from "./LineNotes.tsx";
import { decidingLine, shownBump } from "./line-state.ts";
import { applyEdit } from "./program-actions.ts";
import styles from "./program.module.css";
import { useAdviceText } from "./use-advice-text.ts";

export function Otherwise() {
  "use memo";
  const { t } = useTranslation();
  const { workspace, run, advice } = useServices();
  const action = useStore(workspace, (state) => state.program.default);
  const isDeciding = useStore(run, ({ snapshot }) => decidingLine(snapshot) === "default");
  const bump = useStore(
    run,
    useShallow((state) => shownBump("default", state)),
  );
  const given = useStore(advice, (state) => adviceOn("default", state));
  const text = useAdviceText(given, null);
  const name =
    bump !== null ? "otherwiseBumped" : isDeciding ? "otherwiseRuns" : ("otherwise" as const);
  return (
    <fieldset
      aria-label={t(`program.${name}`)}
      aria-current={isDeciding ? "step" : undefined}
      className={classNames(
        styles["otherwise"],
        isDeciding && styles["deciding"],
        bump !== null && styles["bumped"],
      )}
    >
      <span className={styles["otherwiseWord"]}>{t("program.otherwise")}</span>
      <ActionMenu
        label={t("program.otherwise")}
        edit="otherwise"
        value={action}
        onChange={(next) =>
          applyEdit(workspace, {
            ok: true,
            program: setDefault(workspace.getState().program, next),
          })
        }
      />
      {(isDeciding || bump !== null) && (
        <RobotFace
          size={22}
          mood={bump === null ? "driving" : "bumped"}
          className={styles["robot"]}
        />
      )}
      <LineNote line="default" bump={bump} className={styles["otherwiseNote"]} />
      {given !== null && text !== null && (
        <div className={styles["otherwiseAdvice"]}>
          <AdviceNote text={text} onHide={() => advice.hide(given)} />
        </div>
      )}
    </fieldset>
  );
}
