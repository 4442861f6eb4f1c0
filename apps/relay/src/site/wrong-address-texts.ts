/** Texts of the page for unknown addresses, by language. Plain text, no HTML. */
export interface WrongAddressTexts {
  title: string;
  text: string;
  home: string;
  /** label of the link to the documentation, for addresses in it */
  docs: string;
}

export const wrongAddressTexts: { en: WrongAddressTexts } & Record<string, WrongAddressTexts> = {
  en: {
    title: "This page does not exist",
    text: "Check the address for a typing mistake. If you followed a link, ask for it again.",
    home: "Go to Corridor",
    docs: "Go to the documentation",
  },
  de: {
    title: "Diese Seite gibt es nicht",
    text: "Prüfe, ob in der Adresse ein Tippfehler ist. Wenn du einem Link gefolgt bist, bitte noch einmal um ihn.",
    home: "Zu Corridor",
    docs: "Zur Dokumentation",
  },
  es: {
    title: "Esta página no existe",
    text: "Comprueba si hay un error en la dirección. Si seguiste un enlace, pídelo otra vez.",
    home: "Ir a Corridor",
    docs: "Ir a la documentación",
  },
  fr: {
    title: "Cette page n’existe pas",
    text: "Vérifie qu’il n’y a pas d’erreur dans l’adresse. Si tu as suivi un lien, redemande-le.",
    home: "Aller à Corridor",
    docs: "Aller à la documentation",
  },
  pt: {
    title: "Esta página não existe",
    text: "Veja se há um erro de digitação no endereço. Se você seguiu um link, peça-o de novo.",
    home: "Ir para o Corridor",
    docs: "Ir para a documentação",
  },
  ja: {
    title: "このページはありません",
    text: "アドレスに打ちまちがいがないか確かめてください。リンクから来たときは、もう一度もらってください。",
    home: "Corridor へ",
    docs: "ドキュメントへ",
  },
  "zh-Hans": {
    title: "没有这个页面",
    text: "请检查地址有没有输错。如果是点链接来的，请再要一次链接。",
    home: "打开 Corridor",
    docs: "打开文档",
  },
  ar: {
    title: "هذه الصفحة غير موجودة",
    text: "تحقّق من عدم وجود خطأ في كتابة العنوان. إذا وصلت عبر رابط، فاطلبه مرة أخرى.",
    home: "انتقل إلى Corridor",
    docs: "انتقل إلى التوثيق",
  },
};
