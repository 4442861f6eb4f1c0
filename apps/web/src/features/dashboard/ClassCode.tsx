/** The letters and the QR code by which students join. */
import { ChevronDown, Lock, LockOpen, QrCode as QrIcon, RefreshCw } from "lucide";
import { useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { shownCode } from "../../model/classes/shown-code.ts";
import { CopyButton } from "../../ui/CopyButton.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { MenuItem, Popover, usePopover } from "../../ui/Popover.tsx";
import { QrCode } from "../../ui/QrCode.tsx";
import { qrPath } from "../../ui/qr-path.ts";
import { useContent, useDashboard } from "./dashboard-context.ts";
import styles from "./class-code.module.css";

/** @param isLarge until students have joined */
export function ClassCode({ isLarge }: { isLarge: boolean }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const code = useDashboard(({ classroom }) => classroom?.settings.code ?? "");
  const isLocked = useDashboard(({ classroom }) => classroom?.settings.locked === true);
  const [isOpen, setOpen] = useState(false);
  const letters = useRef<HTMLElement>(null);
  const address = `${location.origin}/join`;
  const qr = isLarge || isOpen ? qrPath(`${address}#${code}`) : null;
  return (
    <section className={styles["code"]} data-large={isLarge} aria-label={t("code.label")}>
      {isLarge && <p className={styles["nobody"]}>{t("code.nobody")}</p>}
      <div className={styles["words"]}>
        <span className={styles["address"]} dir="ltr">
          {location.host}/join
        </span>
        <strong ref={letters} className={styles["letters"]} dir="ltr">
          {shownCode(code)}
        </strong>
        {isLocked && <span className={styles["locked"]}>{t("code.locked")}</span>}
        <span className={styles["buttons"]}>
          <CopyButton
            text={`${address}#${code}`}
            label={t("code.copy")}
            done={t("code.copied")}
            onRefused={() => {
              if (letters.current !== null) getSelection()?.selectAllChildren(letters.current);
            }}
          />
          {!isLarge && (
            <IconButton label={t("code.show")} onClick={() => setOpen(true)}>
              <Icon of={QrIcon} />
            </IconButton>
          )}
          <CodeMenu isLocked={isLocked} />
        </span>
      </div>
      {isLarge && qr !== null && (
        <div className={styles["qr"]}>
          <QrCode code={qr} />
        </div>
      )}
      <Dialog
        isOpen={isOpen && !isLarge}
        onClose={() => setOpen(false)}
        title={t("code.label")}
        isText
      >
        <div className={styles["shown"]}>
          <p className={styles["address"]} dir="ltr">
            {location.host}/join
          </p>
          <p className={styles["letters"]} dir="ltr">
            {shownCode(code)}
          </p>
          {qr !== null && <QrCode code={qr} />}
        </div>
      </Dialog>
    </section>
  );
}

function CodeMenu({ isLocked }: { isLocked: boolean }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, report } = useContent();
  const menu = usePopover();
  return (
    <>
      <IconButton label={t("code.more")} {...menu.trigger}>
        <Icon of={ChevronDown} />
      </IconButton>
      <Popover {...menu.panel} label={t("code.more")} align="end">
        <MenuItem
          icon={<Icon of={isLocked ? LockOpen : Lock} />}
          onSelect={() => void calls.lock(!isLocked).then(report)}
        >
          {isLocked ? t("code.unlock") : t("code.lock")}
        </MenuItem>
        <MenuItem
          icon={<Icon of={RefreshCw} />}
          note={t("code.newNote")}
          onSelect={() => void calls.newCode().then(report)}
        >
          {t("code.new")}
        </MenuItem>
      </Popover>
    </>
  );
}
