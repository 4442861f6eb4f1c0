/** The program's name, undo and redo, and the preset algorithms. */
import { MAX_NAME_LENGTH, rename } from "@corridor/program";
import { BookOpen, Code, Redo2, Undo2 } from "lucide";
import { useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { beginStroke, redo, undo } from "../../model/workspace/workspace-store.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";
import { useRights } from "../../model/use-rights.ts";
import { isExample } from "../../model/workspace/example.ts";
import { applyEdit } from "../../model/workspace/program-actions.ts";
import styles from "./program-header.module.css";
import { useGoalSentence } from "./use-goal-sentence.ts";

const AlgorithmList = lazyPart(async () => (await import("./AlgorithmList.tsx")).AlgorithmList);
const ProgramCode = lazyPart(async () => (await import("./ProgramCode.tsx")).ProgramCode);

export function ProgramHeader() {
  const { t } = useTranslation();
  const rights = useRights();
  const [isCode, setCode] = useState(false);
  const title = <h2 className="visually-hidden">{t("program.program")}</h2>;
  // A challenge offers no preset algorithms. Its card already shows the name, and the lines need
  // the space.
  if (rights !== null) return title;
  return (
    <header>
      <div className={styles["header"]}>
        {title}
        <ProgramName />
        <AlgorithmMenu />
        <IconButton
          label={t("program.code")}
          aria-expanded={isCode}
          onClick={() => setCode(!isCode)}
        >
          <Icon of={Code} />
        </IconButton>
        <UndoRedo />
      </div>
      <Explanation />
      {isCode && <ProgramCode />}
    </header>
  );
}

/** The goal. With the example or an empty program, how a program works. */
function Explanation() {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const isOwn = useStore(
    workspace,
    ({ program }) => program.rules.length > 0 && !isExample(program),
  );
  const goal = useGoalSentence();
  return <p className={styles["explanation"]}>{isOwn ? goal : t("program.explanation")}</p>;
}

export function UndoRedo() {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const canUndo = useStore(workspace.temporal, (state) => state.pastStates.length > 0);
  const canRedo = useStore(workspace.temporal, (state) => state.futureStates.length > 0);
  return (
    <>
      <IconButton label={t("program.undo")} disabled={!canUndo} onClick={() => undo(workspace)}>
        <Icon of={Undo2} isDirectional />
      </IconButton>
      <IconButton label={t("program.redo")} disabled={!canRedo} onClick={() => redo(workspace)}>
        <Icon of={Redo2} isDirectional />
      </IconButton>
    </>
  );
}

/** The title is a field. All edits between focus and blur form one step of the history. */
function ProgramName() {
  const { t } = useTranslation();
  const { workspace } = useServices();
  const name = useStore(workspace, ({ program }) => program.name);
  const endStroke = useRef<(() => void) | null>(null);
  function endEdit(): void {
    endStroke.current?.();
    endStroke.current = null;
  }
  return (
    <input
      className={styles["name"]}
      aria-label={t("program.nameLabel")}
      placeholder={t("program.unnamed")}
      maxLength={MAX_NAME_LENGTH}
      autoComplete="off"
      spellCheck={false}
      value={name}
      onChange={(event) => {
        endStroke.current ??= beginStroke(workspace);
        applyEdit(workspace, rename(workspace.getState().program, event.target.value));
      }}
      onKeyDown={(event) => {
        if (event.key === "Enter") endEdit();
      }}
      onBlur={endEdit}
    />
  );
}

function AlgorithmMenu() {
  const { t } = useTranslation();
  const menu = usePopover();
  return (
    <>
      <IconButton label={t("program.algorithms")} {...menu.trigger}>
        <Icon of={BookOpen} isDirectional />
      </IconButton>
      <Popover {...menu.panel} label={t("program.algorithms")} align="end">
        <h3 className={styles["menuTitle"]}>{t("program.algorithms")}</h3>
        <AlgorithmList onChosen={menu.close} />
      </Popover>
    </>
  );
}
