/** The language as a field in the phone's menu, because the native list suits a thumb. */
import { Globe } from "lucide";
import { useTranslation } from "react-i18next";
import { useLanguageChoice } from "../../model/language-context.ts";
import { shownLanguage } from "../../text/i18n.ts";
import { listedLanguages } from "../../text/languages.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Select } from "../../ui/Select.tsx";
import styles from "./language.module.css";

export function LanguageSelect() {
  const { t, i18n } = useTranslation();
  const choice = useLanguageChoice();
  const shown = shownLanguage(i18n);
  return (
    <Select
      label={t("language.language")}
      className={styles["select"]}
      value={shown}
      options={listedLanguages(shown).map(({ tag, name }) => ({ value: tag, label: name }))}
      icon={<Icon of={Globe} />}
      onChange={(tag) => void choice.choose(tag)}
    />
  );
}
