/**
 * Move up, move down and delete: three small buttons, or one large button for touch that opens
 * them.
 */
import { ArrowDown, ArrowUp, Ellipsis, Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { IconButton } from "../../ui/Button.tsx";
import { MenuItem, Popover, usePopover } from "../../ui/Popover.tsx";
import { useRights } from "../../model/use-rights.ts";
import styles from "./line-tools.module.css";

interface LineToolsProps {
  line: number;
  isFirst: boolean;
  isLast: boolean;
  onMove: (by: -1 | 1) => void;
  onDelete: () => void;
}

export function LineTools(props: LineToolsProps) {
  const isBig = useMediaQuery("(max-width: 37.49em), (pointer: coarse)");
  const edits = useRights()?.edits;
  const canMove = edits?.has("order") ?? true;
  const canDelete = edits?.has("lines") ?? true;
  if (!canMove && !canDelete) return null;
  const tools = { ...props, canMove, canDelete };
  return isBig ? <ToolMenu {...tools} /> : <ToolButtons {...tools} />;
}

interface AllowedTools extends LineToolsProps {
  /** what an open challenge permits */
  canMove: boolean;
  canDelete: boolean;
}

function ToolButtons({
  canMove,
  canDelete,
  line,
  isFirst,
  isLast,
  onMove,
  onDelete,
}: AllowedTools) {
  const { t } = useTranslation();
  return (
    <div className={styles["tools"]}>
      <IconButton
        className={styles["tool"]}
        label={t("program.moveUp", { line })}
        data-move="up"
        disabled={isFirst || !canMove}
        onClick={() => onMove(-1)}
      >
        <Icon of={ArrowUp} />
      </IconButton>
      <IconButton
        className={styles["tool"]}
        label={t("program.moveDown", { line })}
        data-move="down"
        disabled={isLast || !canMove}
        onClick={() => onMove(1)}
      >
        <Icon of={ArrowDown} />
      </IconButton>
      <IconButton
        className={styles["tool"]}
        label={t("program.delete", { line })}
        disabled={!canDelete}
        onClick={onDelete}
      >
        <Icon of={Trash2} />
      </IconButton>
    </div>
  );
}

function ToolMenu({ canMove, canDelete, line, isFirst, isLast, onMove, onDelete }: AllowedTools) {
  const { t } = useTranslation();
  const menu = usePopover();
  return (
    <>
      <IconButton label={t("program.lineMenu", { line })} size="large" {...menu.trigger}>
        <Icon of={Ellipsis} />
      </IconButton>
      <Popover {...menu.panel} label={t("program.lineMenu", { line })} align="end">
        <MenuItem
          icon={<Icon of={ArrowUp} />}
          disabled={isFirst || !canMove}
          onSelect={() => onMove(-1)}
        >
          {t("program.up")}
        </MenuItem>
        <MenuItem
          icon={<Icon of={ArrowDown} />}
          disabled={isLast || !canMove}
          onSelect={() => onMove(1)}
        >
          {t("program.down")}
        </MenuItem>
        <MenuItem icon={<Icon of={Trash2} />} disabled={!canDelete} onSelect={onDelete}>
          {t("program.remove")}
        </MenuItem>
      </Popover>
    </>
  );
}
