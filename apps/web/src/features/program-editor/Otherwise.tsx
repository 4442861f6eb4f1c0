/** The action when no line is true. It is always the last row. */
import { setDefault } from "@corridor/program";
import { useLayoutEffect, type RefObject } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useShallow } from "zustand/react/shallow";
import { useServices } from "../../model/use-services.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { classNames } from "../../ui/class-names.ts";
import { followText } from "../../ui/follow-text.ts";
import { RobotFace } from "../../ui/RobotFace.tsx";
import { ActionMenu } from "./ActionMenu.tsx";
import { adviceOn } from "../../model/advice/advice-store.ts";
import { LazyAdviceNote } from "./lazy-advice.ts";
import { LineNote } from "./LineNotes.tsx";
import frame from "./line-frame.module.css";
import { isDriving, shownBump } from "../../model/run/line-state.ts";
import { applyEdit } from "../../model/workspace/program-actions.ts";
import styles from "./otherwise.module.css";
import { useAdviceText } from "./use-advice-text.ts";

interface OtherwiseProps {
  /** the element that `useRunningLine` marks */
  element: RefObject<HTMLFieldSetElement | null>;
}

export function Otherwise({ element }: OtherwiseProps) {
  "use memo";
  const { t } = useTranslation();
  const { workspace, run, advice } = useServices();
  const action = useStore(workspace, (state) => state.program.default);
  const bump = useStore(
    run,
    useShallow((state) => shownBump("default", action, state)),
  );
  const given = useStore(advice, (state) => adviceOn("default", state));
  const text = useAdviceText(given, null);
  const isBumped = bump !== null;
  useLayoutEffect(() => {
    const resting = t(isBumped ? "program.otherwiseBumped" : "program.otherwise");
    const running = isBumped ? resting : t("program.otherwiseRuns");
    const nameOf = ({ snapshot }: RunState): string =>
      isDriving("default", snapshot) ? running : resting;
    return followText(run, nameOf, (name) => element.current?.setAttribute("aria-label", name));
  }, [element, run, t, isBumped]);
  return (
    <fieldset
      ref={element}
      className={classNames(frame["frame"], styles["otherwise"], isBumped && frame["bumped"])}
    >
      <span className={styles["word"]}>{t("program.otherwise")}</span>
      <ActionMenu
        label={t("program.otherwiseAction")}
        edit="otherwise"
        value={action}
        onChange={(next) =>
          applyEdit(workspace, {
            ok: true,
            program: setDefault(workspace.getState().program, next),
          })
        }
      />
      <RobotFace
        size={22}
        mood={isBumped ? "bumped" : "driving"}
        className={classNames(frame["robot"], styles["robot"])}
      />
      <LineNote line="default" bump={bump} />
      {given !== null && text !== null && (
        <div className={styles["advice"]}>
          <LazyAdviceNote isWanted text={text} onHide={() => advice.hide(given)} />
        </div>
      )}
    </fieldset>
  );
}
