/**
 * The View menu: what the stage displays besides maze and robot, and the figures behind its
 * measures.
 */
import { ChevronDown, Eye } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { Popover, usePopover } from "../../ui/Popover.tsx";
import { FullScreenButton } from "./FullScreenButton.tsx";
import styles from "./tool-strip.module.css";
import type { ViewMenuProps } from "./ViewMenuContent.tsx";

const ViewMenuContent = lazyPart(
  async () => (await import("./ViewMenuContent.tsx")).ViewMenuContent,
);

export function ViewMenu(props: ViewMenuProps) {
  const { t } = useTranslation();
  const menu = usePopover();
  return (
    <div className={styles["view"]}>
      <Button {...menu.trigger} kind="quiet" size="small" icon={<Icon of={Eye} />}>
        <span className={styles["word"]}>{t("stage.view")}</span>
        <Icon of={ChevronDown} className={styles["caret"]} />
      </Button>
      <Popover {...menu.panel} label={t("stage.view")} align="end">
        <ViewMenuContent {...props} />
      </Popover>
      <FullScreenButton />
    </div>
  );
}
