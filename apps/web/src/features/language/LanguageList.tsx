/** The list of all languages, each in its own words. */
import { Check } from "lucide";
import { useTranslation } from "react-i18next";
import { useLanguageChoice } from "../../model/language-context.ts";
import { shownLanguage } from "../../text/i18n.ts";
import { listedLanguages } from "../../text/languages.ts";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./language.module.css";

/**
 * A menu of radio items. Arrow keys move the focus, and Enter or Space chooses, so that moving
 * loads nothing.
 */
export function LanguageList({ onChosen }: { onChosen: () => void }) {
  const { t, i18n } = useTranslation();
  const choice = useLanguageChoice();
  const shown = shownLanguage(i18n);
  return (
    <div role="menu" tabIndex={-1} aria-label={t("language.language")} onKeyDown={walk}>
      {listedLanguages(shown).map(({ tag, name, dir }) => (
        <button
          key={tag}
          ref={tag === shown ? focusFirst : undefined}
          type="button"
          role="menuitemradio"
          aria-checked={tag === shown}
          tabIndex={tag === shown ? 0 : -1}
          lang={tag}
          className={styles["language"]}
          onClick={() => {
            onChosen();
            void choice.choose(tag);
          }}
        >
          <bdi dir={dir}>{name}</bdi>
          {tag === shown && <Icon of={Check} size={18} />}
        </button>
      ))}
    </div>
  );
}

/** Focuses the current language when the list opens. */
function focusFirst(item: HTMLElement | null): void {
  item?.focus();
}

const steps: Readonly<Record<string, (at: number, count: number) => number>> = {
  ArrowDown: (at, count) => (at + 1) % count,
  ArrowUp: (at, count) => (at - 1 + count) % count,
  Home: () => 0,
  End: (_at, count) => count - 1,
};

function walk(event: React.KeyboardEvent<HTMLElement>): void {
  const step = steps[event.key];
  if (step === undefined) return;
  event.preventDefault();
  const items = [...event.currentTarget.querySelectorAll<HTMLElement>("[role=menuitemradio]")];
  const at = items.findIndex((item) => item === document.activeElement);
  items[step(at, items.length)]?.focus();
}
