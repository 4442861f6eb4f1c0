/** Top bar button that opens the path of missions. */
import { Target } from "lucide";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import styles from "./lessons-button.module.css";

export function LessonsButton() {
  const { t } = useTranslation();
  const { challenge } = useServices();
  return (
    <Button
      kind="quiet"
      icon={<Icon of={Target} />}
      aria-haspopup="dialog"
      className={styles["button"]}
      onClick={() => challenge.setState({ isPathOpen: true })}
    >
      <span className={styles["word"]}>{t("lessons.lessons")}</span>
    </Button>
  );
}
