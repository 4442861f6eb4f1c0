/**
 * Items that do not fit into a narrow bar. On a phone, they include Remote, which has no panel
 * there.
 */
import { Keyboard, RadioTower, Target } from "lucide";
import { useTranslation } from "react-i18next";
import { FileItems } from "./lazy-menus.tsx";
import { LanguageSelect } from "../features/language/LanguageSelect.tsx";
import { ThemeChoice } from "../features/theme/ThemeChoice.tsx";
import { Icon } from "../ui/Icon.tsx";
import { MenuItem } from "../ui/Popover.tsx";
import { useTool } from "../model/use-rights.ts";
import { useServices } from "../model/use-services.ts";
import styles from "./more-menu.module.css";

export interface TopBarProps {
  isPhone: boolean;
  onKeys: () => void;
  onRemote: () => void;
  onLessons: () => void;
}

export function MoreMenu({ isPhone, onKeys, onRemote, onLessons }: TopBarProps) {
  const { t } = useTranslation();
  const { screen } = useServices();
  const hasRemote = useTool("remote");
  return (
    <>
      {isPhone && (
        <>
          <MenuItem icon={<Icon of={Target} />} onSelect={onLessons}>
            {t("lessons.lessons")}
          </MenuItem>
          {hasRemote && (
            <MenuItem icon={<Icon of={RadioTower} />} onSelect={onRemote}>
              {t("drive.remote")}
            </MenuItem>
          )}
        </>
      )}
      <MenuItem icon={<Icon of={Keyboard} />} onSelect={onKeys}>
        {t("shell.keys.title")}
      </MenuItem>
      <FileItems />
      <div className={styles["choice"]}>
        <ThemeChoice screen={screen} />
      </div>
      <div className={styles["choice"]}>
        <LanguageSelect />
      </div>
    </>
  );
}
