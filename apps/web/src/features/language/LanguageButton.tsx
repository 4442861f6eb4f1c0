/** The language in the top bar: its short name opens the list of all languages. */
import { Globe } from "lucide";
import { useTranslation } from "react-i18next";
import { shownLanguage } from "../../text/i18n.ts";
import { joinList } from "../../text/joined.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";
import styles from "./language.module.css";
import { shortName } from "./short-name.ts";

const LanguageList = lazyPart(async () => (await import("./LanguageList.tsx")).LanguageList);

export function LanguageButton() {
  const { t, i18n } = useTranslation();
  const menu = usePopover();
  const shown = shownLanguage(i18n);
  return (
    <>
      <Button
        kind="quiet"
        className={styles["trigger"]}
        aria-label={joinList(t, [shortName(shown), t("language.language")])}
        icon={<Icon of={Globe} />}
        {...menu.trigger}
      >
        {shortName(shown)}
      </Button>
      <Popover {...menu.panel} label={t("language.language")} align="end">
        <LanguageList onChosen={menu.close} />
      </Popover>
    </>
  );
}
