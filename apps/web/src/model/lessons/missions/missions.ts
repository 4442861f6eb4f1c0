/** The path of missions, in its order. */
import { firstMissions } from "./first-missions.ts";
import { lineMissions } from "./line-missions.ts";
import { mazeMissions } from "./maze-missions.ts";
import type { Mission } from "./mission.ts";

export const missions: readonly Mission[] = [...firstMissions, ...lineMissions, ...mazeMissions];
