/**
 * Scripts in other languages and without the library. The displayed text masks the key, because a
 * projector may show it.
 */
import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import { CodeField } from "../../ui/CodeField.tsx";
import { CopyButton } from "../../ui/CopyButton.tsx";
import { maskKey, type RobotAddress } from "../../model/remote/robot-address.ts";
import { snippet, snippetFiles, snippetLanguages, type SnippetLanguage } from "./snippets.ts";
import panel from "./remote.module.css";
import styles from "./snippets.module.css";

/** Lines of the longest script. */
const SHOWN_LINES = 12;

export function Snippets({ address }: { address: RobotAddress }) {
  const { t } = useTranslation();
  const [language, setLanguage] = useState<SnippetLanguage>("javascript");
  const [isRefused, setRefused] = useState(false);
  const name = useId();
  const { file, command, program } = snippetFiles[language];
  const full = snippet(language, address.api, address.key);
  return (
    <section className={panel["section"]} aria-label={t("remote.otherLanguages")}>
      <div className={panel["bar"]}>
        <fieldset className={styles["tabs"]}>
          <legend className="visually-hidden">{t("remote.scriptLanguage")}</legend>
          {snippetLanguages.map((each) => (
            <label key={each} className={styles["tab"]}>
              <input
                type="radio"
                name={name}
                className={styles["radio"]}
                checked={each === language}
                onChange={() => setLanguage(each)}
              />
              {t(`remote.${each}`)}
            </label>
          ))}
        </fieldset>
        <CopyButton
          text={full}
          label={t("remote.copyScript")}
          done={t("remote.copied")}
          kind="quiet"
          size="small"
          onRefused={() => setRefused(true)}
        />
      </div>
      <CodeField
        label={t("remote.otherLanguages")}
        lines={SHOWN_LINES}
        text={isRefused ? full : snippet(language, address.api, maskKey(address.key))}
      />
      <p className={panel["note"]}>
        {t(isRefused ? "remote.copyByHand" : "remote.scriptNote", { file, command })}{" "}
        {program !== null && t("remote.scriptNeeds", { program })}
      </p>
    </section>
  );
}
