/** Tabs: one row of tabs and one panel; arrow keys move between the tabs. */
import { useId, type ReactNode } from "react";
import styles from "./tabs.module.css";

interface TabsProps<Value extends string> {
  label: string;
  value: Value;
  tabs: readonly { value: Value; label: string; icon?: ReactNode }[];
  onChange: (value: Value) => void;
  panelClassName?: string | undefined;
  /** content of the selected tab */
  children: ReactNode;
}

export function Tabs<Value extends string>({
  label,
  value,
  tabs,
  onChange,
  panelClassName,
  children,
}: TabsProps<Value>) {
  const id = useId();
  const chosen = tabs.findIndex((tab) => tab.value === value);

  function choose(index: number): void {
    const tab = tabs[(index + tabs.length) % tabs.length];
    if (tab === undefined) return;
    onChange(tab.value);
    document.getElementById(`${id}-${tab.value}`)?.focus();
  }

  function onKeyDown(event: React.KeyboardEvent): void {
    if (event.key === "ArrowRight") choose(chosen + 1);
    else if (event.key === "ArrowLeft") choose(chosen - 1);
    else if (event.key === "Home") choose(0);
    else if (event.key === "End") choose(tabs.length - 1);
    else return;
    event.preventDefault();
  }

  return (
    <>
      <div role="tablist" aria-label={label} className={styles["tabs"]}>
        {tabs.map((tab) => (
          <button
            key={tab.value}
            id={`${id}-${tab.value}`}
            type="button"
            role="tab"
            className={styles["tab"]}
            aria-selected={tab.value === value}
            aria-controls={`${id}-panel`}
            tabIndex={tab.value === value ? 0 : -1}
            onClick={() => onChange(tab.value)}
            onKeyDown={onKeyDown}
          >
            {tab.icon}
            {tab.label}
          </button>
        ))}
      </div>
      {/* A new panel for each tab starts at its top, however far the previous one was scrolled. */}
      <div
        key={value}
        role="tabpanel"
        id={`${id}-panel`}
        aria-labelledby={`${id}-${value}`}
        className={panelClassName}
      >
        {children}
      </div>
    </>
  );
}
