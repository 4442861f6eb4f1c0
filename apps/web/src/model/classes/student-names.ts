/**
 * The words that students get as names. The relay assigns the number of a word, so the order of
 * the list is part of the format: a word may be replaced, but never moved.
 */
const text = `
Acorn Agate Alder Almond Amber Anchor Anvil Apple Apricot Arrow Ash Aspen Aster Atlas Aurora Autumn
Badger Balloon Bamboo Banjo Basil Beacon Beaver Beech Beetle Berry Birch Bison Blossom Bobcat Breeze Bridge
Brook Bronze Bubble Buffalo Butter Button Cactus Camel Candle Canoe Canyon Caramel Cardinal Carrot Castle Cedar
Cello Cherry Chestnut Cinnamon Citrus Clarinet Cliff Cloud Clover Cobalt Coconut Comet Compass Copper Coral Cosmos
Cotton Cougar Crane Crater Crayon Cricket Crystal Cypress Daisy Dandelion Dawn Delta Denim Desert Diamond Dolphin
Domino Dragonfly Drum Dune Eagle Echo Eclipse Elk Elm Ember Emerald Falcon Feather Fern Fiddle Finch
Firefly Fjord Flamingo Flint Flute Forest Fossil Fountain Galaxy Garnet Gazelle Geyser Ginger Giraffe Glacier Globe
Grape Granite Gravel Guitar Harbor Harp Hawk Hazel Heather Heron Hickory Honey Horizon Hummingbird Igloo Indigo
Iris Island Ivory Ivy Jade Jasmine Jasper Jigsaw Juniper Jupiter Kayak Kestrel Kettle Kite Kiwi Koala
Lagoon Lantern Larch Lark Laurel Lava Lavender Lemon Lens Leopard Lichen Lilac Lily Linen Lotus Lynx
Magnet Magnolia Mango Maple Marble Marigold Meadow Melon Mercury Meteor Mint Mirror Mist Moon Moss Mustard
Nebula Nectar Neptune Nest Nickel Nutmeg Oak Oasis Oboe Ocean Olive Onyx Opal Orbit Orchid Otter
Owl Oyster Paddle Palm Panda Papaya Parrot Peach Pearl Pebble Pelican Penguin Pepper Piano Pine Pixel
Planet Plum Polar Poppy Prairie Prism Puffin Pumpkin Quartz Quasar Rabbit Rainbow Raven Reef Ribbon River
Robin Rocket Rosemary Ruby Saffron Sail Sapphire Saturn Seal Shadow Silver Sparrow Spruce Star Sunflower Swan
Tangerine Teal Thistle Thunder Tiger Topaz Tulip Turtle Velvet Violet Walnut Willow Winter Wren Zebra Zinnia
`;

export const studentWords: readonly string[] = text.trim().split(/\s+/);
