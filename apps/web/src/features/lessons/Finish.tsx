/** End of the path: a picture to save with the trail of the student's own program. */
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { formatClock } from "../../text/numbers.ts";
import { Button } from "../../ui/Button.tsx";
import { FieldError } from "../../ui/FieldError.tsx";
import type { SolvedTrail } from "../../simulator/protocol/bonus-request.ts";
import { fileName } from "../../ui/file-name.ts";
import { lightPalette, pngOf } from "../../stage/svg/picture.ts";
import { saveFile } from "../../ui/save-file.ts";
import { finishPicture } from "./finish-picture.ts";
import type { LessonsRecord } from "../../model/lessons/lessons-storage.ts";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import styles from "./finish.module.css";
import { missionIds } from "../../model/lessons/missions/mission.ts";

interface FinishProps {
  service: LessonsService;
  done: LessonsRecord["done"];
}

export function Finish({ service, done }: FinishProps) {
  const { t, i18n } = useTranslation(["missions", "words"], { useSuspense: false });
  const { language } = i18n;
  const { speech } = useServices();
  const [trail, setTrail] = useState<SolvedTrail | null>(null);
  const [hasFailed, setHasFailed] = useState<"trail" | "png" | null>(null);
  // The date on which the dialog opened.
  const [today] = useState(() => new Date());
  useEffect(() => {
    let isOver = false;
    void service.trails.last().then(
      (found) => {
        if (!isOver) setTrail(found);
      },
      () => {
        if (!isOver) setHasFailed("trail");
      },
    );
    return () => {
      isOver = true;
    };
  }, [service]);
  const results = missionIds.flatMap((id) => done[id] ?? []);
  const lines = results.reduce((sum, each) => sum + each.lines, 0);
  const ticks = results.reduce((sum, each) => sum + each.ticks, 0);
  const count = missionIds.length;
  const title = t("missions:finish.title", { count });
  const date = new Intl.DateTimeFormat(language, { dateStyle: "long" }).format(today);
  const counts = t("missions:finish.counts", { lines, time: formatClock(ticks, language) });
  const maze = trail?.maze.name ?? "";
  const description = t("missions:finish.description", { title, date, counts, maze });
  const picture =
    trail === null
      ? null
      : finishPicture({
          trail,
          palette: lightPalette(),
          dir: i18n.dir() === "rtl" ? "rtl" : "ltr",
          startWord: t("words:stage.startWord"),
          goalWord: t("words:stage.goalWord"),
          ...isolated({ title, date, counts, description }),
        });

  function save(content: Blob, ending: string): void {
    saveFile(content, `${fileName(`corridor ${title}`, "corridor")}.${ending}`);
    speech.announce(t("missions:finish.saved"));
  }

  return (
    <section className={styles["finish"]} aria-label={title}>
      {picture !== null && (
        <img
          className={styles["finishPicture"]}
          src={`data:image/svg+xml;charset=utf-8,${encodeURIComponent(picture.svg)}`}
          width={picture.width}
          height={picture.height}
          alt={description}
        />
      )}
      <div className={styles["finishText"]}>
        <h3 className={styles["title"]}>{title}</h3>
        <p>{t("missions:finish.text")}</p>
        {hasFailed !== null && (
          <FieldError id="finish-error">
            {t(hasFailed === "png" ? "words:files.picture.failed" : "words:lessons.notLoaded")}
          </FieldError>
        )}
        {picture !== null && (
          <div className={styles["actions"]}>
            <Button
              size="small"
              kind="primary"
              onClick={() =>
                void pngOf(picture).then(
                  (png) => save(png, "png"),
                  () => setHasFailed("png"),
                )
              }
            >
              {t("words:files.picture.png")}
            </Button>
            <Button
              size="small"
              onClick={() => save(new Blob([picture.svg], { type: "image/svg+xml" }), "svg")}
            >
              {t("words:files.picture.svg")}
            </Button>
          </div>
        )}
      </div>
    </section>
  );
}

/**
 * Removes isolate characters (U+2066 to U+2069). An image viewer draws them as boxes where its font
 * lacks them.
 */
function isolated<Texts extends Record<string, string>>(texts: Texts): Texts {
  const entries = Object.entries(texts).map(([key, text]) => [
    key,
    text.replaceAll(/[\u2066-\u2069]/g, ""),
  ]);
  return Object.fromEntries(entries) as Texts;
}
