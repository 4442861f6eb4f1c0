/** Whether the newest edit is stored on this device, in words. */
import { CircleCheck, TriangleAlert } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { classNames } from "../../ui/class-names.ts";
import styles from "./maze-menu.module.css";

/** In the bar it is displayed beside the name where there is room, in the menu always. */
export function SaveState({ isInMenu = false }: { isInMenu?: boolean }) {
  const { t } = useTranslation();
  const { screen } = useServices();
  const saved = useStore(screen, (state) => state.saved);
  const words = {
    saved: t("projects.savedHere"),
    saving: t("projects.saving"),
    blocked: t("projects.notSaved"),
  };
  const isBad = saved === "blocked";
  return (
    <p
      className={classNames(
        styles["state"],
        isInMenu ? styles["inMenu"] : styles["inBar"],
        isBad && styles["bad"],
      )}
    >
      {isBad && <Icon of={TriangleAlert} size={16} />}
      {!isBad && isInMenu && <Icon of={CircleCheck} size={16} />}
      {words[saved]}
    </p>
  );
}
