/** The menu item that saves the maze for contests. Appears once its texts are loaded. */
import { Trophy } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../../ui/Icon.tsx";
import { MenuItem } from "../../../ui/Popover.tsx";

export function ContestMenuItem({ onSelect }: { onSelect: () => void }) {
  const { t, ready } = useTranslation("contest", { useSuspense: false });
  if (!ready) return null;
  return (
    <MenuItem icon={<Icon of={Trophy} />} onSelect={onSelect}>
      {t("save.open")}
    </MenuItem>
  );
}
