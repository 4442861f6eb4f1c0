/** The menu of actions of a line. */
import { menuActions } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { classNames } from "../../ui/class-names.ts";
import { Select } from "../../ui/Select.tsx";
import { useRights } from "../../model/use-rights.ts";
import { ActionIcon } from "../../ui/ProgramIcons.tsx";
import styles from "./action-menu.module.css";

interface ActionMenuProps {
  label: string;
  value: PlainAction;
  onChange: (action: PlainAction) => void;
  /** the part that a challenge may lock: the action of a line, or the one after "otherwise" */
  edit?: "action" | "otherwise";
}

/** An action that the challenge does not offer remains an option while the program uses it. */
export function ActionMenu({ label, value, onChange, edit = "action" }: ActionMenuProps) {
  const { t } = useTranslation();
  const rights = useRights();
  const offered = rights?.actions ?? menuActions;
  const actions = offered.includes(value) ? offered : [...offered, value];
  const isFixed = rights?.edits.has(edit) === false;
  return (
    <Select
      label={label}
      className={classNames(styles["action"], isFixed && styles["fixed"])}
      value={value}
      disabled={isFixed}
      title={isFixed ? t("lessons.partFixed") : undefined}
      options={actions.map((action) => ({ value: action, label: t(`program.action.${action}`) }))}
      icon={<ActionIcon action={value} />}
      onChange={onChange}
    />
  );
}
