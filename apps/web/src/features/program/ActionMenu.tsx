/** What a line does: the menu of the paper's actions. */
import { menuActions } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import { useTranslation } from "react-i18next";
import { Select } from "../../ui/Select.tsx";
import { ActionIcon } from "./ProgramIcons.tsx";
import styles from "./program.module.css";

interface ActionMenuProps {
  label: string;
  value: PlainAction;
  onChange: (action: PlainAction) => void;
}

/** An action that the paper's menu does not have (stop) stays a choice while a program uses it. */
export function ActionMenu({ label, value, onChange }: ActionMenuProps) {
  const { t } = useTranslation();
  const actions = menuActions.includes(value) ? menuActions : [...menuActions, value];
  return (
    <Select
      label={label}
      className={styles["action"]}
      value={value}
      options={actions.map((action) => ({ value: action, label: t(`program.action.${action}`) }))}
      icon={<ActionIcon action={value} />}
      onChange={onChange}
    />
  );
}
