/** A link as a QR code that can be saved as a picture. */
import { Download } from "lucide";
import { useRef } from "react";
import { useTranslation } from "react-i18next";
import { Icon } from "./Icon.tsx";
import { Button } from "./Button.tsx";
import { QrCode } from "./QrCode.tsx";
import { qrPath } from "./qr-path.ts";
import { savePicture } from "./save-picture.ts";
import styles from "./qr-card.module.css";

export function QrCard({ link, name }: { link: string; name: string }) {
  const { t } = useTranslation();
  const picture = useRef<SVGSVGElement>(null);
  const code = qrPath(link);
  if (code === null) return <p className={styles["noQr"]}>{t("share.noQr")}</p>;
  return (
    <figure className={styles["qr"]} aria-label={t("share.qr")}>
      <QrCode ref={picture} code={code} />
      <h3 className={styles["scan"]}>{t("share.scan")}</h3>
      <p className={styles["note"]}>{t("share.scanNote")}</p>
      <Button
        size="small"
        icon={<Icon of={Download} />}
        onClick={() => {
          if (picture.current !== null) savePicture(picture.current, name);
        }}
      >
        {t("share.savePicture")}
      </Button>
    </figure>
  );
}
