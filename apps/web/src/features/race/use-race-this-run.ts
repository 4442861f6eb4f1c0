/** Handler of "Race this run". The rest of the code loads with the first press. */
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";

export function useRaceThisRun() {
  const services = useServices();
  const { i18n } = useTranslation();
  const [isBusy, setBusy] = useState(false);
  const race = () => {
    setBusy(true);
    void import("./race-this-run.ts")
      .then(({ raceThisRun }) => raceThisRun(services, i18n))
      .catch(() => undefined)
      .finally(() => setBusy(false));
  };
  return { race, isBusy };
}
