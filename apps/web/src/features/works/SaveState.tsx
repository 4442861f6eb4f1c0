/** Whether the newest edit is stored on this device, in words. */
import { CircleCheck, TriangleAlert } from "lucide-react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { classNames } from "../../ui/class-names.ts";
import styles from "./maze-menu.module.css";

/** In the bar it is displayed beside the name where there is room, in the menu always. */
export function SaveState({ isInMenu = false }: { isInMenu?: boolean }) {
  const { t } = useTranslation();
  const { screen } = useServices();
  const saved = useStore(screen, (state) => state.saved);
  const words = {
    saved: t("works.savedHere"),
    saving: t("works.saving"),
    blocked: t("works.notSaved"),
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
      {isBad && <TriangleAlert size={16} aria-hidden="true" />}
      {!isBad && isInMenu && <CircleCheck size={16} aria-hidden="true" />}
      {words[saved]}
    </p>
  );
}
