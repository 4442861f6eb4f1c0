/** The bar of the dashboard: the label of the class, and what concerns everyone. */
import { ChevronDown, Ellipsis, Eye, EyeOff, Link2, LogOut, Monitor, Send } from "lucide";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { classAddress, secondDeviceAddress } from "../../model/classroom/class-address.ts";
import { MAX_CLASS_LABEL, type OwnClass } from "../../model/classroom/own-classes.ts";
import { Button, IconButton } from "../../ui/Button.tsx";
import { ButtonLink } from "../../ui/ButtonLink.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { MenuItem, Popover, usePopover } from "../../ui/Popover.tsx";
import { QrCode } from "../../ui/QrCode.tsx";
import { qrPath } from "../../ui/qr-path.ts";
import { TextField } from "../../ui/TextField.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { PauseControl } from "./PauseControl.tsx";
import styles from "./dashboard.module.css";

export function DashboardBar({
  label,
  onLabel,
}: {
  label: string;
  onLabel: (label: string) => void;
}) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const menu = usePopover();
  return (
    <>
      <button type="button" className={styles["label"]} {...menu.trigger}>
        <span className={styles["labelText"]} dir="auto">
          {label || t("class")}
        </span>
        <Icon of={ChevronDown} size={16} />
      </button>
      <Popover {...menu.panel} label={t("label.menu")}>
        <div className={styles["form"]}>
          <TextField
            label={t("label.name")}
            value={label}
            maxLength={MAX_CLASS_LABEL}
            onChange={onLabel}
          />
          <p className={styles["note"]}>{t("label.note")}</p>
        </div>
      </Popover>
    </>
  );
}

interface DashboardBarEndProps {
  isOver: boolean;
  hidesNames: boolean;
  onHideNames: (hidesNames: boolean) => void;
  onSend: () => void;
  /** on a phone: elsewhere the button is below the cards */
  onEnd: () => void;
  room: OwnClass;
  tools: ReactNode;
}

export function DashboardBarEnd({
  isOver,
  hidesNames,
  onHideNames,
  onSend,
  onEnd,
  room,
  tools,
}: DashboardBarEndProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const isNarrow = useMediaQuery("(max-width: 71.24em)");
  const isSmall = useMediaQuery("(max-width: 56.24em)");
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  const menu = usePopover();
  const [isJoining, setJoining] = useState(false);
  if (isOver) return tools;
  const names = hidesNames ? t("showNames") : t("hideNames");
  const namesIcon = <Icon of={hidesNames ? Eye : EyeOff} />;
  return (
    <>
      {!isNarrow && (
        <Button kind="quiet" icon={namesIcon} onClick={() => onHideNames(!hidesNames)}>
          {names}
        </Button>
      )}
      {!isSmall && room.screenKey !== null && (
        <ButtonLink kind="quiet" icon={<Icon of={Monitor} />} {...screenLink(room)}>
          {t("screen.open")}
        </ButtonLink>
      )}
      {!isNarrow && (
        <Button icon={<Icon of={Send} isDirectional />} onClick={onSend}>
          {t("send.open")}
        </Button>
      )}
      <PauseControl isSmall={isPhone} />
      {!isPhone && tools}
      <IconButton label={t("more")} size="medium" {...menu.trigger}>
        <Icon of={Ellipsis} />
      </IconButton>
      <Popover {...menu.panel} label={t("more")} align="end">
        {isNarrow && (
          <MenuItem icon={namesIcon} onSelect={() => onHideNames(!hidesNames)}>
            {names}
          </MenuItem>
        )}
        {isNarrow && (
          <MenuItem icon={<Icon of={Send} isDirectional />} onSelect={onSend}>
            {t("send.open")}
          </MenuItem>
        )}
        {isSmall && room.screenKey !== null && (
          <MenuItem
            icon={<Icon of={Monitor} />}
            onSelect={() => window.open(screenLink(room).href, "_blank", "noopener")}
          >
            {t("screen.open")}
          </MenuItem>
        )}
        {room.screenKey === null && (
          <MenuItem
            icon={<Icon of={Monitor} />}
            disabled
            note={t("screen.elsewhere")}
            onSelect={() => undefined}
          >
            {t("screen.open")}
          </MenuItem>
        )}
        <MenuItem icon={<Icon of={Link2} />} onSelect={() => setJoining(true)}>
          {t("device.open")}
        </MenuItem>
        {isPhone && (
          <>
            <MenuItem icon={<Icon of={LogOut} isDirectional />} onSelect={onEnd}>
              {t("end.open")}
            </MenuItem>
            <div className={styles["tools"]}>{tools}</div>
          </>
        )}
      </Popover>
      <DeviceDialog room={room} isOpen={isJoining} onClose={() => setJoining(false)} />
    </>
  );
}

/** A big screen of the class, in a window of its own. */
function screenLink({ id, screenKey }: OwnClass) {
  return {
    href: classAddress(location.origin, id, screenKey ?? ""),
    target: "_blank",
    rel: "noopener",
  };
}

/** The dashboard's own address, for a second device of the teacher. */
function DeviceDialog({
  room,
  isOpen,
  onClose,
}: {
  room: OwnClass;
  isOpen: boolean;
  onClose: () => void;
}) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const code = isOpen ? qrPath(secondDeviceAddress(location.origin, room)) : null;
  return (
    <Dialog isOpen={isOpen} onClose={onClose} title={t("device.title")} width="narrow" isText>
      <p>{t("device.text")}</p>
      {code !== null && (
        <div className={styles["qr"]}>
          <QrCode code={code} />
        </div>
      )}
    </Dialog>
  );
}
