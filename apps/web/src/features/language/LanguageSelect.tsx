/** The language as a field, for the phone's menu: the phone's own list is the one for a thumb. */
import { Globe } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useLanguageChoice } from "../../app/language-context.ts";
import { shownLanguage } from "../../text/i18n.ts";
import { languageOf, offeredLanguages } from "../../text/languages.ts";
import { Select } from "../../ui/Select.tsx";
import styles from "./language.module.css";

export function LanguageSelect() {
  const { t, i18n } = useTranslation();
  const choice = useLanguageChoice();
  const shown = languageOf(shownLanguage(i18n));
  const isDraft = !offeredLanguages.some(({ tag }) => tag === shown.tag);
  const shownChoices = isDraft ? [shown, ...offeredLanguages] : offeredLanguages;
  return (
    <Select
      label={t("language.language")}
      className={styles["select"]}
      value={shown.tag}
      options={shownChoices.map(({ tag, name }) => ({ value: tag, label: name }))}
      icon={<Globe aria-hidden="true" />}
      onChange={(tag) => void choice.choose(tag)}
    />
  );
}
