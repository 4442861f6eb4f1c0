/** The state of a student: an icon and a word. */
import { Check, Hand, Minus, Pause, Pencil, Play, TriangleAlert, Unplug } from "lucide";
import type { ReactNode } from "react";
import { useTranslation } from "react-i18next";
import type { Standing } from "../../model/classroom/standing.ts";
import { BurstIcon } from "../../ui/BurstIcon.tsx";
import { Chip } from "../../ui/Chip.tsx";
import { Icon } from "../../ui/Icon.tsx";

/**
 * A working student writes, drives, or waits in a pause of the class; a claimed solution is checked,
 * does not pass, or has no code to check.
 */
export type CardState =
  | Exclude<Standing, "working">
  | "writing"
  | "driving"
  | "paused"
  | "checking"
  | "unverified"
  | "unchecked";

const looks: Record<
  CardState,
  { tone: "ring" | "live" | "good" | "bad" | "dashed"; icon: ReactNode }
> = {
  help: { tone: "bad", icon: <Icon of={Hand} /> },
  stuck: { tone: "bad", icon: <Icon of={TriangleAlert} /> },
  bumped: { tone: "bad", icon: <BurstIcon size={13} /> },
  writing: { tone: "ring", icon: <Icon of={Pencil} /> },
  driving: { tone: "live", icon: <Icon of={Play} fill="currentColor" /> },
  paused: { tone: "ring", icon: <Icon of={Pause} /> },
  checking: { tone: "ring", icon: <Icon of={Check} /> },
  unchecked: { tone: "ring", icon: <Icon of={Check} /> },
  unverified: { tone: "bad", icon: <Icon of={TriangleAlert} /> },
  disconnected: { tone: "dashed", icon: <Icon of={Unplug} /> },
  solved: { tone: "good", icon: <Icon of={Check} /> },
  "not-here": { tone: "dashed", icon: <Icon of={Minus} /> },
};

export function StandingChip({ state }: { state: CardState }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  return (
    <Chip tone={looks[state].tone} icon={looks[state].icon}>
      {t(`standing.${state}`)}
    </Chip>
  );
}
