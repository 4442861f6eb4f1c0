/** The dropdown editor: the lines from the top, otherwise, and a new line. */
import { MAX_RULES, setDefault } from "@corridor/program";
import { Plus } from "lucide-react";
import { Fragment, useState } from "react";
import { flushSync } from "react-dom";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { tell } from "../../stores/screen-store.ts";
import { classNames } from "../../ui/class-names.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { ActionMenu } from "./ActionMenu.tsx";
import { decidingLine, isPassedOver } from "./line-state.ts";
import { addLine, applyEdit } from "./program-actions.ts";
import styles from "./program.module.css";
import { ProgramHeader } from "./ProgramHeader.tsx";
import { ProgramLine } from "./ProgramLine.tsx";

export function ProgramEditor() {
  const { t } = useTranslation();
  return (
    <section className={styles["editor"]} aria-label={t("program.program")}>
      <ProgramHeader />
      <ProgramLines />
    </section>
  );
}

function ProgramLines() {
  const { t } = useTranslation();
  const { workspace, run, screen } = useServices();
  const program = useStore(workspace, (state) => state.program);
  const lineIds = useStore(workspace, (state) => state.lineIds);
  const deciding = useStore(run, ({ snapshot }) => decidingLine(snapshot));
  const [remembered] = useState(() => new Map<number, number>());

  function add() {
    const id = flushSync(() => addLine(workspace));
    if (id === null) {
      tell(screen, { tone: "bad", text: t("program.full", { max: MAX_RULES }) });
      return;
    }
    document.querySelector<HTMLElement>(`#program-line-${id} select`)?.focus();
  }

  return (
    <div className={styles["body"]}>
      {program.rules.length > 0 && (
        <ol className={styles["lines"]}>
          {program.rules.map((rule, index) => {
            const id = lineIds[index];
            if (id === undefined) return null;
            return (
              <Fragment key={id}>
                {index > 0 && deciding === index - 1 && (
                  <li className={styles["rule"]} aria-hidden="true">
                    {t("program.notRead")}
                  </li>
                )}
                <ProgramLine
                  id={id}
                  index={index}
                  count={program.rules.length}
                  rule={rule}
                  isDeciding={deciding === index}
                  isPassedOver={isPassedOver(index, deciding)}
                  remembered={remembered}
                />
              </Fragment>
            );
          })}
        </ol>
      )}
      <Otherwise isDeciding={deciding === "default"} />
      <button type="button" className={styles["add"]} onClick={add}>
        <Plus size={18} aria-hidden="true" />
        {t("program.addLine")}
      </button>
    </div>
  );
}

/** What the robot does when no line is true; always last. */
function Otherwise({ isDeciding }: { isDeciding: boolean }) {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const action = useStore(workspace, (state) => state.program.default);
  return (
    <fieldset
      aria-label={t(isDeciding ? "program.otherwiseRuns" : "program.otherwise")}
      aria-current={isDeciding ? "step" : undefined}
      className={classNames(styles["otherwise"], isDeciding && styles["deciding"])}
    >
      <span className={styles["otherwiseWord"]}>{t("program.otherwise")}</span>
      <ActionMenu
        label={t("program.otherwise")}
        value={action}
        onChange={(next) =>
          applyEdit(workspace, {
            ok: true,
            program: setDefault(workspace.getState().program, next),
          })
        }
      />
      {isDeciding && <RobotFace size={22} className={styles["robot"]} />}
    </fieldset>
  );
}
