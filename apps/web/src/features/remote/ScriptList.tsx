/**
 * The scripts by name, with the last command of each, a button that blocks or unblocks each, a
 * button that pauses all, and whether they may reset the robot.
 */
import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { joinList } from "../../text/joined.ts";
import { Button } from "../../ui/Button.tsx";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { classNames } from "../../ui/class-names.ts";
import type { ListedScript, RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { quietSeconds, shownScripts } from "./listed-scripts.ts";
import { unblockScript, pauseDriving, permitReset, blockScript } from "./owner-calls.ts";
import { useNow } from "./use-now.ts";
import panel from "./remote.module.css";
import rows from "./list-rows.module.css";
import styles from "./script-list.module.css";

export function ScriptList({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const { remote } = useServices();
  const scripts = useStore(remote, (state) => state.scripts);
  const now = useNow(scripts.length > 0);
  const [isFailed, setFailed] = useState(false);
  const isPaused = useStore(remote, (state) => state.isPaused);
  const mayReset = useStore(remote, (state) => state.mayReset);
  const shown = shownScripts(scripts, now);
  const pause = async (): Promise<void> => {
    setFailed(!(await pauseDriving(fetch, session, !isPaused)));
  };
  const permit = async (isPermitted: boolean): Promise<void> => {
    setFailed(!(await permitReset(fetch, session, isPermitted)));
  };
  const change = async (script: ListedScript): Promise<void> => {
    const isDone = script.isBlocked
      ? await unblockScript(fetch, session, script.id)
      : await blockScript(fetch, session, script);
    setFailed(!isDone);
  };
  return (
    <section className={panel["section"]} aria-labelledby="scripts-heading">
      <div className={panel["bar"]}>
        <h2 id="scripts-heading" className={panel["heading"]}>
          {t("remote.scripts")}
        </h2>
        <Button
          size="small"
          kind={isPaused ? "primary" : "outline"}
          className={panel["long"]}
          onClick={() => void pause()}
        >
          {isPaused ? t("remote.letDrive") : t("remote.pauseScripts")}
        </Button>
      </div>
      <output className={isPaused ? styles["paused"] : panel["note"]}>
        {isPaused && t("remote.pausedNote")}
      </output>
      <Checkbox
        label={t("remote.mayReset")}
        checked={mayReset}
        onChange={(isPermitted) => void permit(isPermitted)}
      />
      <ul className={rows["rows"]}>
        {shown.map((script) => (
          <ScriptRow
            key={script.id}
            script={script}
            now={now}
            onChange={() => void change(script)}
          />
        ))}
      </ul>
      <p className={panel["note"]}>
        <output>{isFailed && t("remote.actionFailed")}</output>
        {!isFailed && shown.length > 0 && t("remote.scriptsNote")}
      </p>
    </section>
  );
}

interface ScriptRowProps {
  script: ListedScript;
  now: number;
  onChange: () => void;
}

function ScriptRow({ script, now, onChange }: ScriptRowProps) {
  const { t } = useTranslation();
  const id = useId();
  const language = useLanguageName(script.client);
  const details = useDetails(script, now);
  return (
    <li className={classNames(rows["row"], script.isBlocked && rows["blocked"])}>
      <div className={rows["words"]}>
        <p id={id} className={rows["name"]}>
          <bdi>{script.name ?? language}</bdi>
        </p>
        <p className={panel["note"]}>
          {joinList(t, script.name === null ? details : [language, ...details])}
        </p>
        {script.lastProblem !== null && <LastProblem {...script.lastProblem} />}
      </div>
      <Button size="small" aria-describedby={id} onClick={onChange}>
        {script.isBlocked ? t("remote.unblock") : t("remote.block")}
      </Button>
    </li>
  );
}

/** Why the relay refused a command of the script. Its sentences are in English. */
function LastProblem({ detail, at }: { detail: string; at: string }) {
  const { t, i18n } = useTranslation();
  const clock = new Intl.DateTimeFormat(`${i18n.language}-u-nu-latn`, { timeStyle: "medium" });
  return (
    <p className={classNames(panel["note"], styles["problem"])}>
      {t("remote.problemAt", { time: clock.format(new Date(at)) })} <bdi lang="en">{detail}</bdi>
    </p>
  );
}

/** The last command and its state, and for how long the script has been silent. */
function useDetails(script: ListedScript, now: number): string[] {
  const { t } = useTranslation();
  const { remote } = useServices();
  const { last, lastProblem, isBlocked } = script;
  const state = useStore(
    remote,
    ({ commands }) => commands.find(({ seq }) => seq === last?.seq)?.state ?? null,
  );
  if (isBlocked) return [t("remote.blocked")];
  const seconds = quietSeconds(script, now);
  // A script without a command whose commands were refused does not only read.
  const readsOnly = lastProblem === null ? [t("remote.readsOnly")] : [];
  return [
    ...(last === null ? readsOnly : [t("remote.last", { action: last.action })]),
    ...(state === null ? [] : [t(`remote.${state}`)]),
    ...(seconds > 0 ? [t("remote.quietFor", { seconds })] : []),
  ];
}

/** The relay derives the language from the request's headers, or sends "Script". */
function useLanguageName(client: string): string {
  const { t } = useTranslation();
  return client === "" || client === "Script"
    ? t("remote.someScript")
    : t("remote.scriptIn", { language: client });
}
